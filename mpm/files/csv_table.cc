#include "mpm/files/csv_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "mpm/files/read_file.h"

namespace zona::mpm {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return text.substr(0, 0);
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::string without_byte_order_mark(std::string text) {
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);
  return text;
}

/// Reads the number in a cell. Returns what is wrong with it, or nullptr.
const char* read_number(std::string_view cell, double& number) {
  if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);
  const char* const cell_end = cell.data() + cell.size();
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell_end, value);
  if (error == std::errc::result_out_of_range) return "is out of range";
  if (error != std::errc() || end != cell_end) return "is not a number";
  number = value;
  return std::isfinite(number) ? nullptr : "is not finite";
}

}  // namespace

TableError::TableError(const std::string& file, std::size_t line, std::size_t column,
                       const std::string& problem)
    : std::runtime_error(line == 0 ? fmt::format("{}: {}", file, problem)
                                   : fmt::format("{}:{}:{}: {}", file, line, column, problem)),
      line_(line),
      column_(column) {}

CsvTable CsvTable::read(const std::string& path, const std::vector<CsvColumn>& wanted) {
  std::optional<std::string> text = read_file(path);
  if (!text)
    throw TableError(path, 0, 0, fmt::format("cannot open the file ({})", std::strerror(errno)));
  return parse(std::move(*text), path, wanted);
}

CsvTable CsvTable::parse(std::string text, const std::string& name,
                         const std::vector<CsvColumn>& wanted) {
  CsvTable table(without_byte_order_mark(std::move(text)), name);
  std::vector<Cell> lines = split(*table.text_, '\n');
  const auto is_skipped = [](Cell line) { return line.empty() || line.front() == '#'; };
  lines.erase(std::remove_if(lines.begin(), lines.end(), is_skipped), lines.end());
  if (lines.empty()) throw TableError(name, 0, 0, "the file is empty; it needs a row of headings");
  const std::vector<UnitScale> scales = table.read_headings(split(lines.front(), ','), wanted);
  for (std::size_t i = 1; i < lines.size(); ++i)
    table.add_row(split(lines[i], ','), scales, !wanted.empty());
  if (table.rows() == 0) throw TableError(name, 0, 0, "no values under the headings");
  return table;
}

CsvTable::CsvTable(std::string text, const std::string& file)
    : file_(file), text_(std::make_shared<const std::string>(std::move(text))) {}

std::vector<UnitScale> CsvTable::read_headings(const std::vector<Cell>& headings,
                                               const std::vector<CsvColumn>& wanted) {
  std::vector<UnitScale> scales;
  for (const Cell heading : headings) {
    const std::string name(trimmed(heading.substr(0, heading.find('['))));
    scales.push_back(wanted.empty() ? UnitScale{} : scale_in(heading, name, wanted));
    names_.push_back(name);
  }
  for (const CsvColumn& column : wanted)
    if (column.is_required && !has(column.name))
      throw error_at(headings.front(),
                     fmt::format("no column '{} [{}]'", column.name, column.si_unit));
  columns_.resize(names_.size());
  return scales;
}

UnitScale CsvTable::scale_in(Cell heading, const std::string& name,
                             const std::vector<CsvColumn>& wanted) const {
  const auto column = std::find_if(wanted.begin(), wanted.end(),
                                   [&](const CsvColumn& known) { return known.name == name; });
  if (column == wanted.end()) {
    std::vector<std::string> known;
    for (const CsvColumn& each : wanted) known.push_back(each.name);
    throw error_at(
        heading, fmt::format("unknown heading '{}'; known are: {}", name, fmt::join(known, ", ")));
  }
  const std::size_t bracket = heading.find('[');
  if (bracket == Cell::npos || heading.back() != ']')
    throw error_at(heading, fmt::format("'{}' lacks its unit; write for example '{} [{}]'", heading,
                                        name, column->si_unit));
  if (has(name)) throw error_at(heading, fmt::format("'{}' occurs twice", name));
  const Cell unit = heading.substr(bracket + 1, heading.size() - bracket - 2);
  try {
    return column->scale_of(std::string(trimmed(unit)));
  } catch (const std::runtime_error& error) {
    throw error_at(heading.substr(bracket), error.what());
  }
}

void CsvTable::add_row(std::vector<Cell> cells, const std::vector<UnitScale>& scales,
                       bool must_be_finite) {
  if (cells.size() != names_.size())
    throw error_at(cells.back(),
                   fmt::format("{} values under {} headings", cells.size(), names_.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double value = std::numeric_limits<double>::quiet_NaN();
    const char* problem = read_number(cells[i], value);
    value = value * scales[i].multiplier / scales[i].divisor;
    if (!problem && !std::isfinite(value)) problem = "is out of range";
    if (problem && must_be_finite)
      throw error_at(cells[i], fmt::format("'{}' {}", cells[i], problem));
    columns_[i].push_back(value);
  }
  cells_.push_back(std::move(cells));
}

bool CsvTable::has(const std::string& name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

std::size_t CsvTable::index(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end())
    throw TableError(
        file_, 0, 0,
        fmt::format("it has no column {}; there are {}", name, fmt::join(names_, ", ")));
  return static_cast<std::size_t>(found - names_.begin());
}

const std::vector<double>& CsvTable::operator[](const std::string& name) const {
  return columns_[index(name)];
}

CsvTable CsvTable::where(const std::string& name, const std::string& text) const {
  const std::size_t place = index(name);
  CsvTable chosen = *this;
  chosen.cells_.clear();
  chosen.columns_.assign(names_.size(), {});
  for (std::size_t row = 0; row < rows(); ++row) {
    if (cells_[row][place] != text) continue;
    chosen.cells_.push_back(cells_[row]);
    for (std::size_t i = 0; i < columns_.size(); ++i)
      chosen.columns_[i].push_back(columns_[i][row]);
  }
  if (chosen.rows() == 0)
    throw TableError(file_, 0, 0, fmt::format("it has no row whose {} is {}", name, text));
  return chosen;
}

TableError CsvTable::error(std::size_t row, const std::string& name,
                           const std::string& problem) const {
  return error_at(cells_.at(row)[index(name)], problem);
}

TableError CsvTable::error_at(Cell cell, const std::string& problem) const {
  const std::string_view before(text_->data(), cell.data() - text_->data());
  const std::size_t line_begin = before.rfind('\n') + 1;  // 0 in the first line
  const auto newlines = std::count(before.begin(), before.end(), '\n');
  return {file_, static_cast<std::size_t>(newlines) + 1, before.size() - line_begin + 1, problem};
}

}  // namespace zona::mpm
