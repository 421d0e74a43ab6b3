#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "mpm/points/state_visitor.h"

namespace zona::studies {

/// A column of a table of results; the unit is SI, empty for a pure number.
struct Column {
  std::string name;
  std::string unit;
};

/// A table that grows while a study runs, e.g. history.csv: a header with units ("time [s]"), then
/// one row per sample with every digit of a double. What is written reaches the disk within a
/// second or so, and at the latest when the object goes.
class HistoryFile {
 public:
  /// Throws RunError when the file cannot be written. A file that goes on keeps its rows until
  /// `visit_state` tells which of them count.
  HistoryFile(const std::filesystem::path& file, const std::vector<Column>& columns,
              bool goes_on = false);

  /// Adds a row, one value per column. Throws RunError when the file cannot be written.
  void add(const std::vector<double>& row);
  /// The same for a table whose first column holds words without commas.
  void add(const std::string& word, const std::vector<double>& row);
  /// The rows so far: brings them to the disk, or drops later ones. Throws RunError when some are
  /// missing.
  void visit_state(mpm::StateVisitor& visitor);

 private:
  void write(std::string line, const std::vector<double>& row, std::size_t values);

  std::filesystem::path file_;
  std::ofstream stream_;
  std::size_t width_;
  std::chrono::steady_clock::time_point flushed_;
};

}  // namespace zona::studies
