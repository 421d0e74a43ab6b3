#include "studies/input/table_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "mpm/files/read_file.h"
#include "studies/input/units.h"

namespace zona::studies {

namespace {

using Cells = std::vector<std::string>;

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

Cells split(const std::string& line) {
  Cells cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(trimmed(cell));
  if (!line.empty() && line.back() == ',') cells.emplace_back();
  return cells;
}

/// Reads the rows of one table and keeps count of lines.
class TableParser {
 public:
  TableParser(const std::string& text, const std::string& name,
              const std::vector<TableColumn>& columns)
      : stream_(text), name_(name), columns_(columns) {}

  std::vector<std::vector<double>> parse() {
    Cells cells;
    if (!next_row(cells)) fail("the file is empty; a row of headings is wanted: " + wanted());
    read_headings(cells);
    std::vector<std::vector<double>> values(columns_.size());
    while (next_row(cells)) {
      if (cells.size() != place_.size())
        fail(fmt::format("{} values under {} headings", cells.size(), place_.size()));
      for (std::size_t i = 0; i < cells.size(); ++i)
        values[place_[i]].push_back(factor_[i] * number(cells[i]));
    }
    if (values.front().empty()) fail("no values; at least one row is wanted");
    return values;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", name_, line_, problem));
  }

  std::string wanted() const {
    std::string headings;
    for (const TableColumn& column : columns_)
      headings +=
          fmt::format("{}{} [{}]", headings.empty() ? "" : ", ", column.name, column.si_unit);
    return headings;
  }

  bool next_row(Cells& cells) {
    for (std::string line; std::getline(stream_, line);) {
      ++line_;
      line = trimmed(line);
      if (line.empty() || line.front() == '#') continue;
      cells = split(line);
      return true;
    }
    return false;
  }

  void read_headings(const Cells& cells) {
    for (const std::string& cell : cells) {
      const std::size_t bracket = cell.find('[');
      const std::string heading = trimmed(cell.substr(0, bracket));
      const auto found = std::find_if(columns_.begin(), columns_.end(),
                                      [&](const TableColumn& c) { return c.name == heading; });
      if (found == columns_.end())
        fail(fmt::format("unknown heading '{}'; wanted are {}", heading, wanted()));
      if (bracket == std::string::npos || cell.back() != ']')
        fail(fmt::format("'{}' lacks its unit; write for example {} [{}]", cell, heading,
                         found->si_unit));
      const std::string unit = trimmed(cell.substr(bracket + 1, cell.size() - bracket - 2));
      const auto place = static_cast<std::size_t>(found - columns_.begin());
      if (std::count(place_.begin(), place_.end(), place) > 0)
        fail(fmt::format("'{}' occurs twice", heading));
      try {
        factor_.push_back(parse_quantity("1 " + unit, found->si_unit));
      } catch (const UnitError& error) {
        fail(fmt::format("{}: {}", heading, error.what()));
      }
      place_.push_back(place);
    }
    if (place_.size() < columns_.size()) fail("columns are missing; wanted are " + wanted());
  }

  double number(const std::string& text) const {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      fail(fmt::format("'{}' is not a finite number", text));
    return value;
  }

  std::istringstream stream_;
  const std::string& name_;
  const std::vector<TableColumn>& columns_;
  std::size_t line_ = 0;
  std::vector<std::size_t> place_;  ///< which of the columns stands where
  std::vector<double> factor_;      ///< of their units
};

}  // namespace

std::vector<std::vector<double>> parse_table(const std::string& text, const std::string& name,
                                             const std::vector<TableColumn>& columns) {
  return TableParser(text, name, columns).parse();
}

std::vector<std::vector<double>> read_table(const std::string& path,
                                            const std::vector<TableColumn>& columns) {
  const std::optional<std::string> text = mpm::read_file(path);
  if (!text)
    throw std::runtime_error(fmt::format("{}: cannot be read ({})", path, std::strerror(errno)));
  return parse_table(*text, path, columns);
}

}  // namespace zona::studies
