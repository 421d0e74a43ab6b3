#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mpm/files/csv_table.h"

namespace zona::studies::verification {

/// A CSV table of a run. NaN where a cell holds no number.
using ResultTable = mpm::CsvTable;

/// What a finished run left in its directory.
class RunResults {
 public:
  /// Throws RunError when there is no summary.
  explicit RunResults(const std::filesystem::path& directory);

  const std::filesystem::path& directory() const { return directory_; }
  /// "results" of summary.json, SI units.
  const nlohmann::json& results() const { return summary_.at("results"); }
  /// A number of the results. Throws RunError when there is none of this name.
  double number(const std::string& name) const;
  double wall_seconds() const;
  /// A table of the run, e.g. "history.csv". Throws mpm::TableError.
  ResultTable table(const std::string& name) const {
    return ResultTable::read((directory_ / name).string());
  }

 private:
  std::filesystem::path directory_;
  nlohmann::json summary_;
};

/// The runs of a case by their labels.
class CaseResults {
 public:
  void add(const std::string& label, RunResults results) {
    runs_.emplace(label, std::move(results));
  }
  /// Throws std::out_of_range for a run that the case did not ask for.
  const RunResults& operator[](const std::string& label) const { return runs_.at(label); }
  bool has(const std::string& label) const { return runs_.count(label) > 0; }

 private:
  std::map<std::string, RunResults> runs_;
};

/// Linear interpolation of y over ascending x; the end values outside.
double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at);

}  // namespace zona::studies::verification
