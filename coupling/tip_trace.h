#pragma once

#include <string>
#include <string_view>

#include "beam/motion/tip_history.h"
#include "mpm/files/csv_table.h"

namespace zona::coupling {

/// A trace of the tip's motion that cannot be read or used.
using TraceError = mpm::TableError;

/// Reads a computed or measured trace from a CSV file:
///
///     # comments and empty lines are skipped
///     time [us], displacement [um], velocity [m/s]
///     0, 0, 0
///     0.6, 1.25e-3, 0.004
///
/// Columns, in any order: `time` and `displacement` (required); `velocity`, `acceleration` and
/// `support` (optional). Units: s ms us ns; m mm um nm pm; m/s mm/s um/s mm/ms um/ms um/us;
/// m/s^2 mm/s^2 um/us^2. Micro may be u or the Greek letter. A missing velocity is replaced by the
/// second-order difference (`second_order_slopes`) of the displacement, a missing acceleration by
/// that of the velocity, a missing support by zero. Times must increase; at least three samples are
/// needed. Throws `TraceError`.
beam::TipHistory read_tip_trace_csv(const std::string& path);

/// Reads the same format from a text in memory; `name` replaces the file's name in errors.
beam::TipHistory parse_tip_trace_csv(std::string_view text, const std::string& name);

/// Writes all columns in SI units, exactly, and replaces the file atomically. Throws `TraceError`
/// if the vectors differ in length, `mpm::FileError` if the file cannot be written.
void write_tip_trace_csv(const beam::TipHistory& history, const std::string& path);

/// Reads the datasets /time, /displacement, ... [SI units] of an HDF5 file, with the same rules.
/// Throws `TraceError` and `mpm::Hdf5Error`.
beam::TipHistory read_tip_trace_hdf5(const std::string& path);
/// Writes all vectors as such datasets, exactly. Throws `TraceError` if they differ in length,
/// `mpm::Hdf5Error` and `mpm::FileError` if the file cannot be written.
void write_tip_trace_hdf5(const beam::TipHistory& history, const std::string& path);

/// True if the extension of a trace means HDF5: ".h5" or ".hdf5".
bool is_hdf5_trace(const std::string& path);

/// Reads HDF5 if `is_hdf5_trace`, or else CSV.
beam::TipHistory read_tip_trace(const std::string& path);

/// Throws `TraceError` unless the history has at least three samples, vectors of one length, finite
/// values and strictly increasing times. `name` identifies the history in the error.
void check_tip_history(const beam::TipHistory& history, const std::string& name);

/// Fills the empty vectors of a history by the rules of `read_tip_trace_csv`. Throws `TraceError`
/// if the others are inconsistent.
void complete_tip_history(beam::TipHistory& history, const std::string& name);

}  // namespace zona::coupling
