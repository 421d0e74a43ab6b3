#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "beam/motion/tip_history.h"

namespace zona::coupling {

/// A trace of the tip's motion that cannot be read, or not be used. `what()` reads
/// "file:line:column: problem"; line and column count from 1, in bytes, and are 0 (and left
/// out) where the problem has no place.
class TraceError : public std::runtime_error {
 public:
  /// A line or column of 0 is left out of the text.
  TraceError(const std::string& file, std::size_t line, std::size_t column,
             const std::string& problem);
  /// From 1; 0 where the problem has no place.
  std::size_t line() const { return line_; }
  /// In bytes from 1; 0 where the problem has no place.
  std::size_t column() const { return column_; }

 private:
  std::size_t line_;
  std::size_t column_;
};

/// Reads a trace from a CSV file, computed or measured:
///
///     # comments and empty lines are skipped
///     time [us], displacement [um], velocity [m/s]
///     0, 0, 0
///     0.6, 1.25e-3, 0.004
///
/// Columns, in any order: `time` and `displacement` (wanted); `velocity`, `acceleration` and
/// `support` (optional). Units: s ms us ns; m mm um nm pm; m/s mm/s um/s mm/ms um/ms um/us;
/// m/s^2 mm/s^2 um/us^2. Micro may be u or the Greek letter.
/// An absent velocity is the second-order difference (`second_order_slopes`) of the displacement,
/// an absent acceleration that of the velocity; an absent support stands still at zero.
/// Times must increase; at least three samples are wanted. Throws `TraceError`.
beam::TipHistory read_tip_trace_csv(const std::string& path);

/// The same from a text in memory; `name` stands for the file's name in errors.
beam::TipHistory parse_tip_trace_csv(std::string_view text, const std::string& name);

/// Writes all columns in SI units, to the last bit, replacing the file atomically.
/// Throws `TraceError` if the vectors differ in length, `mpm::FileError` if the file fails.
void write_tip_trace_csv(const beam::TipHistory& history, const std::string& path);

/// Reads the datasets /time, /displacement, ... [SI units] of an HDF5 file, with the same rules.
/// Throws `TraceError` and `mpm::Hdf5Error`.
beam::TipHistory read_tip_trace_hdf5(const std::string& path);
/// Writes all vectors as such datasets, to the last bit. Throws `TraceError` if they differ in
/// length, `mpm::Hdf5Error` if the file fails.
void write_tip_trace_hdf5(const beam::TipHistory& history, const std::string& path);

/// Whether a trace is taken for HDF5, by its ending: ".h5" or ".hdf5".
bool is_hdf5_trace(const std::string& path);

/// Reads either format: HDF5 if `is_hdf5_trace`, or else CSV.
beam::TipHistory read_tip_trace(const std::string& path);

/// Throws `TraceError` unless the history has at least three samples, vectors of one length, finite
/// values and strictly increasing times. `name` says in the error whose history it is.
void check_tip_history(const beam::TipHistory& history, const std::string& name);

/// Fills in what a trace lacks (its vectors are empty), as `read_tip_trace_csv` says. Throws
/// `TraceError` if what it has is inconsistent.
void complete_tip_history(beam::TipHistory& history, const std::string& name);

}  // namespace zona::coupling
