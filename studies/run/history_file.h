#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "mpm/points/state_visitor.h"
#include "studies/run/columns.h"

namespace zona::studies {

/// A table that grows while a study runs, e.g. history.csv: a header with units ("time [s]"), then
/// one row per sample with every digit of a double. Rows reach the disk within about a second, and
/// at the latest when the object is destroyed.
class HistoryFile {
 public:
  /// Throws RunError when the file cannot be written. A file of a resumed run keeps its rows until
  /// `visit_state` removes those after the checkpoint.
  HistoryFile(const std::filesystem::path& file, const std::vector<Column>& columns,
              bool is_resumed = false);

  /// Adds a row, one value per column. Throws RunError when the file cannot be written.
  void add(const std::vector<double>& row);
  /// Adds a row of a table whose first column holds words without commas.
  void add(const std::string& word, const std::vector<double>& row);
  /// Storing brings the rows to the disk; restoring removes rows that came after the checkpoint.
  /// Throws RunError when rows are missing.
  void visit_state(mpm::StateVisitor& visitor);

 private:
  void write(std::string line, const std::vector<double>& row, std::size_t values);

  std::filesystem::path file_;
  std::ofstream stream_;
  std::size_t width_;
  std::chrono::steady_clock::time_point flushed_;
};

}  // namespace zona::studies
