#pragma once

#include <catch2/catch.hpp>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/studies/study_files.h"

namespace zona::studies::testing {

/// Columns of a CSV file by their names without units; words become NaN.
inline std::map<std::string, std::vector<double>> read_columns(const std::filesystem::path& file) {
  std::istringstream stream(read_text(file));
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::string line;
  std::getline(stream, line);
  std::vector<std::string> names = cells_of(line);
  for (std::string& name : names) name = name.substr(0, name.find(" ["));
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = cells_of(line);
    REQUIRE(cells.size() == names.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      char* end = nullptr;
      const double value = std::strtod(cells[c].c_str(), &end);
      columns[names[c]].push_back(*end == '\0' ? value : std::nan(""));
    }
  }
  return columns;
}

}  // namespace zona::studies::testing
