#include "studies/verification/evaluation/run_results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>

#include "studies/input/input_error.h"

namespace zona::studies::verification {

namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

double number_in(const std::string& cell) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

}  // namespace

ResultTable::ResultTable(const std::filesystem::path& file) : file_(file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) throw RunError(file.string() + " cannot be read");
  for (const std::string& heading : split(line)) {
    names_.push_back(heading.substr(0, heading.find(" [")));
  }
  while (std::getline(stream, line)) {
    cells_.push_back(split(line));
    if (cells_.back().size() != names_.size()) throw RunError(file.string() + " has a torn row");
  }
  if (rows() == 0) throw RunError(file.string() + " holds no rows");
  parse();
}

void ResultTable::parse() {
  columns_.assign(names_.size(), {});
  for (const auto& row : cells_) {
    for (std::size_t c = 0; c < row.size(); ++c) columns_[c].push_back(number_in(row[c]));
  }
}

bool ResultTable::has(const std::string& name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

std::size_t ResultTable::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) {
    throw RunError(fmt::format("{} has no column {}; there are {}", file_.string(), name,
                               fmt::join(names_, ", ")));
  }
  return static_cast<std::size_t>(found - names_.begin());
}

const std::vector<double>& ResultTable::operator[](const std::string& name) const {
  return columns_[column(name)];
}

ResultTable ResultTable::where(const std::string& name, const std::string& text) const {
  const std::size_t c = column(name);
  ResultTable chosen = *this;
  const auto other = [&](const std::vector<std::string>& row) { return row[c] != text; };
  chosen.cells_.erase(std::remove_if(chosen.cells_.begin(), chosen.cells_.end(), other),
                      chosen.cells_.end());
  if (chosen.rows() == 0) {
    throw RunError(fmt::format("{} has no row whose {} is {}", file_.string(), name, text));
  }
  chosen.parse();
  return chosen;
}

RunResults::RunResults(const std::filesystem::path& directory) : directory_(directory) {
  std::ifstream stream(directory / "summary.json");
  summary_ = nlohmann::json::parse(stream, nullptr, false);
  if (summary_.is_discarded() || !summary_.contains("results")) {
    throw RunError((directory / "summary.json").string() + " is missing or no summary of a run");
  }
}

double RunResults::number(const std::string& name) const {
  const auto found = results().find(name);
  if (found == results().end() || !found->is_number()) {
    throw RunError(
        fmt::format("{} has no number {}", (directory_ / "summary.json").string(), name));
  }
  return found->get<double>();
}

double RunResults::wall_seconds() const {
  return summary_.at("cost").at("wall_time").get<double>();
}

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto upper = std::upper_bound(x.begin(), x.end(), at);
  if (upper == x.begin()) return y.front();
  if (upper == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(upper - x.begin());
  const double fraction = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + fraction * (y[i] - y[i - 1]);
}

}  // namespace zona::studies::verification
