#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

#include "coupling/tip_trace.h"
#include "mpm/files/read_file.h"

namespace zona::coupling {

namespace {

using beam::TipHistory;

/// `value * multiplier / divisor` converts to SI. Both factors are powers of ten that are exact in
/// floating point, so that the conversion rounds only once (17.9 / 1e6, not 17.9 * 1e-6).
struct Unit {
  const char* name;
  double multiplier;
  double divisor;
};

const std::vector<Unit> time_units{{"s", 1, 1}, {"ms", 1, 1e3}, {"us", 1, 1e6}, {"ns", 1, 1e9}};
const std::vector<Unit> length_units{
    {"m", 1, 1}, {"mm", 1, 1e3}, {"um", 1, 1e6}, {"nm", 1, 1e9}, {"pm", 1, 1e12}};
const std::vector<Unit> velocity_units{{"m/s", 1, 1},   {"mm/s", 1, 1e3},  {"um/s", 1, 1e6},
                                       {"mm/ms", 1, 1}, {"um/ms", 1, 1e3}, {"um/us", 1, 1}};
const std::vector<Unit> acceleration_units{
    {"m/s^2", 1, 1}, {"mm/s^2", 1, 1e3}, {"um/us^2", 1e6, 1}};

/// A known column of a trace.
struct Heading {
  const char* name;
  std::vector<double> TipHistory::*samples;
  const std::vector<Unit>* units;
  bool required;
};

const std::vector<Heading> headings{
    {"time", &TipHistory::time, &time_units, true},
    {"displacement", &TipHistory::displacement, &length_units, true},
    {"velocity", &TipHistory::velocity, &velocity_units, false},
    {"acceleration", &TipHistory::acceleration, &acceleration_units, false},
    {"support", &TipHistory::support, &length_units, false}};

/// Text between two commas, without surrounding blanks.
struct Cell {
  std::string_view text;
  std::size_t column;  ///< of its first character, from 1 [bytes]
};

struct Column {
  const Heading* heading;
  const Unit* unit;
};

/// Parses the text line by line and counts lines for error messages.
class TraceParser {
 public:
  TraceParser(std::string_view text, const std::string& name) : rest_(text), name_(name) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.substr(0, 3) == byte_order_mark) rest_.remove_prefix(3);
  }

  TipHistory parse() {
    if (!next_line()) fail_file("the file is empty; it needs a row of headings");
    read_headings();
    TipHistory history;
    while (next_line()) read_row(history);
    if (history.time.size() < 3)
      fail_file(fmt::format("{} samples; at least 3 are needed", history.time.size()));
    return history;
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& problem) const {
    throw TraceError(name_, line_, column, problem);
  }
  [[noreturn]] void fail_file(const std::string& problem) const {
    throw TraceError(name_, 0, 0, problem);
  }

  bool next_line();
  void read_headings();
  Column read_heading(const Cell& cell) const;
  void read_row(TipHistory& history) const;
  double read_number(const Cell& cell) const;

  std::string_view rest_;
  const std::string& name_;
  std::size_t line_ = 0;
  std::vector<Cell> cells_;  ///< of the current line
  std::vector<Column> columns_;
};

Cell trimmed(std::string_view text, std::size_t column) {
  constexpr const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {{}, column};
  const std::size_t last = text.find_last_not_of(blanks);
  return {text.substr(first, last - first + 1), column + first};
}

std::vector<Cell> split(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, comma - begin), begin + 1));
    if (comma == std::string_view::npos) return cells;
    begin = comma + 1;
  }
}

/// Advances to the next line that is neither empty nor a comment.
bool TraceParser::next_line() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    const std::string_view text = trimmed(line, 1).text;
    if (text.empty() || text.front() == '#') continue;
    cells_ = split(line);
    return true;
  }
  return false;
}

/// "µs" (micro sign or Greek mu) -> "us", "m/s²" -> "m/s^2".
std::string plain_unit(std::string_view unit) {
  std::string plain(unit);
  const auto replace = [&plain](std::string_view from, const char* to) {
    for (auto at = plain.find(from); at != std::string::npos; at = plain.find(from))
      plain.replace(at, from.size(), to);
  };
  replace("\xC2\xB5", "u");
  replace("\xCE\xBC", "u");
  replace("\xC2\xB2", "^2");
  return plain;
}

template <class Items>
std::string names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.emplace_back(item.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

Column TraceParser::read_heading(const Cell& cell) const {
  const std::size_t bracket = cell.text.find('[');
  const std::string_view name = trimmed(cell.text.substr(0, bracket), 1).text;
  const auto heading = std::find_if(headings.begin(), headings.end(),
                                    [&](const Heading& known) { return name == known.name; });
  if (heading == headings.end())
    fail(cell.column, fmt::format("unknown heading '{}'; known are: {}", name, names_of(headings)));
  if (bracket == std::string_view::npos || cell.text.back() != ']')
    fail(cell.column, fmt::format("'{}' lacks its unit; write for example '{} [{}]'", cell.text,
                                  name, heading->units->front().name));
  const std::string_view inside = cell.text.substr(bracket + 1, cell.text.size() - bracket - 2);
  const std::string given = plain_unit(trimmed(inside, 1).text);
  for (const Unit& unit : *heading->units)
    if (given == unit.name) return {&*heading, &unit};
  fail(cell.column + bracket, fmt::format("unknown unit '{}' of {}; known are: {}", given, name,
                                          names_of(*heading->units)));
}

void TraceParser::read_headings() {
  for (const Cell& cell : cells_) {
    const Column column = read_heading(cell);
    for (const Column& before : columns_)
      if (before.heading == column.heading)
        fail(cell.column, fmt::format("'{}' occurs twice", column.heading->name));
    columns_.push_back(column);
  }
  for (const Heading& heading : headings) {
    const bool found = std::any_of(columns_.begin(), columns_.end(), [&](const Column& column) {
      return column.heading == &heading;
    });
    if (heading.required && !found)
      fail(1, fmt::format("no column '{} [{}]'", heading.name, heading.units->front().name));
  }
}

double TraceParser::read_number(const Cell& cell) const {
  std::string_view text = cell.text;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc::result_out_of_range)
    fail(cell.column, fmt::format("'{}' is out of range", cell.text));
  if (error != std::errc() || end != text.data() + text.size())
    fail(cell.column, fmt::format("'{}' is not a number", cell.text));
  if (!std::isfinite(number)) fail(cell.column, fmt::format("'{}' is not finite", cell.text));
  return number;
}

void TraceParser::read_row(TipHistory& history) const {
  if (cells_.size() != columns_.size())
    fail(cells_.back().column,
         fmt::format("{} values under {} headings", cells_.size(), columns_.size()));
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Column& column = columns_[i];
    std::vector<double>& samples = history.*column.heading->samples;
    samples.push_back(read_number(cells_[i]) * column.unit->multiplier / column.unit->divisor);
    const bool is_time = column.heading == &headings.front();
    if (!std::isfinite(samples.back()))
      fail(cells_[i].column, fmt::format("'{}' is out of range", cells_[i].text));
    if (is_time && samples.size() > 1 && !(samples.back() > samples[samples.size() - 2]))
      fail(cells_[i].column, fmt::format("time {} s is not after the previous time, {} s",
                                         samples.back(), samples[samples.size() - 2]));
  }
}

}  // namespace

TipHistory parse_tip_trace_csv(std::string_view text, const std::string& name) {
  TipHistory history = TraceParser(text, name).parse();
  complete_tip_history(history, name);
  return history;
}

TipHistory read_tip_trace_csv(const std::string& path) {
  const std::optional<std::string> text = mpm::read_file(path);
  if (!text)
    throw TraceError(path, 0, 0, fmt::format("cannot open the file ({})", std::strerror(errno)));
  return parse_tip_trace_csv(*text, path);
}

}  // namespace zona::coupling
