#include "coupling/tip_trace.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupling/slopes.h"
#include "mpm/files/atomic_file.h"
#include "mpm/files/hdf5_file.h"

namespace zona::coupling {

namespace {

using beam::TipHistory;

struct Unit {
  const char* name;
  mpm::UnitScale scale;
};

/// A column of a CSV file, a dataset of an HDF5 file. The first unit is that of SI.
struct Quantity {
  const char* name;
  const std::vector<Unit>& units;
  bool is_required;
  std::vector<double> TipHistory::*samples;
};

const std::vector<Unit> time_units{
    {"s", {1, 1}}, {"ms", {1, 1e3}}, {"us", {1, 1e6}}, {"ns", {1, 1e9}}};
const std::vector<Unit> length_units{
    {"m", {1, 1}}, {"mm", {1, 1e3}}, {"um", {1, 1e6}}, {"nm", {1, 1e9}}, {"pm", {1, 1e12}}};
const std::vector<Unit> velocity_units{{"m/s", {1, 1}},   {"mm/s", {1, 1e3}},  {"um/s", {1, 1e6}},
                                       {"mm/ms", {1, 1}}, {"um/ms", {1, 1e3}}, {"um/us", {1, 1}}};
const std::vector<Unit> acceleration_units{
    {"m/s^2", {1, 1}}, {"mm/s^2", {1, 1e3}}, {"um/us^2", {1e6, 1}}};

const std::vector<Quantity> quantities{
    {"time", time_units, true, &TipHistory::time},
    {"displacement", length_units, true, &TipHistory::displacement},
    {"velocity", velocity_units, false, &TipHistory::velocity},
    {"acceleration", acceleration_units, false, &TipHistory::acceleration},
    {"support", length_units, false, &TipHistory::support}};

const char* si_unit(const Quantity& quantity) {
  return quantity.units.front().name;
}

/// "µs" (micro sign or Greek mu) -> "us", "m/s²" -> "m/s^2".
std::string plain_unit(std::string unit) {
  const auto replace = [&unit](std::string_view from, const char* to) {
    for (auto at = unit.find(from); at != std::string::npos; at = unit.find(from))
      unit.replace(at, from.size(), to);
  };
  replace("\xC2\xB5", "u");
  replace("\xCE\xBC", "u");
  replace("\xC2\xB2", "^2");
  return unit;
}

mpm::UnitScale scale_of(const std::string& unit, const Quantity& quantity) {
  const std::string given = plain_unit(unit);
  std::vector<std::string> known;
  for (const Unit& each : quantity.units) {
    if (given == each.name) return each.scale;
    known.emplace_back(each.name);
  }
  throw std::runtime_error(fmt::format("unknown unit '{}' of {}; known are: {}", given,
                                       quantity.name, fmt::join(known, ", ")));
}

std::vector<mpm::CsvColumn> csv_columns() {
  std::vector<mpm::CsvColumn> columns;
  for (const Quantity& quantity : quantities)
    columns.push_back({quantity.name, si_unit(quantity),
                       [&quantity](const std::string& unit) { return scale_of(unit, quantity); },
                       quantity.is_required});
  return columns;
}

TipHistory history_in(const mpm::CsvTable& table, const std::string& name) {
  TipHistory history;
  for (const Quantity& quantity : quantities)
    if (table.has(quantity.name)) history.*quantity.samples = table[quantity.name];
  const std::vector<double>& time = history.time;
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      throw table.error(
          i, "time",
          fmt::format("time {} s is not after the previous time, {} s", time[i], time[i - 1]));
  complete_tip_history(history, name);
  return history;
}

void check_times(const std::vector<double>& time, const std::string& name) {
  if (time.size() < 3)
    throw TraceError(name, 0, 0, fmt::format("{} samples; at least 3 are needed", time.size()));
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      throw TraceError(
          name, 0, 0,
          fmt::format("time of sample {} is {} s, not after {} s", i, time[i], time[i - 1]));
}

void check_values(const TipHistory& history, const Quantity& quantity, const std::string& name) {
  const std::vector<double>& values = history.*quantity.samples;
  if (values.size() != history.time.size())
    throw TraceError(name, 0, 0,
                     fmt::format("{} values of {} at {} times", values.size(), quantity.name,
                                 history.time.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw TraceError(name, 0, 0,
                       fmt::format("{} of sample {} is {}", quantity.name, i, values[i]));
}

}  // namespace

TipHistory read_tip_trace_csv(const std::string& path) {
  return history_in(mpm::CsvTable::read(path, csv_columns()), path);
}

TipHistory parse_tip_trace_csv(std::string_view text, const std::string& name) {
  return history_in(mpm::CsvTable::parse(std::string(text), name, csv_columns()), name);
}

void check_tip_history(const TipHistory& history, const std::string& name) {
  check_times(history.time, name);
  for (const Quantity& quantity : quantities) check_values(history, quantity, name);
}

void complete_tip_history(TipHistory& history, const std::string& name) {
  check_times(history.time, name);
  for (const Quantity& quantity : quantities)
    if (!(history.*quantity.samples).empty()) check_values(history, quantity, name);
  if (history.velocity.empty())
    history.velocity = second_order_slopes(history.time, history.displacement);
  if (history.acceleration.empty())
    history.acceleration = second_order_slopes(history.time, history.velocity);
  if (history.support.empty()) history.support.assign(history.time.size(), 0.0);
  check_tip_history(history, name);
}

void write_tip_trace_csv(const TipHistory& history, const std::string& path) {
  check_tip_history(history, path);
  std::string text;
  for (const Quantity& quantity : quantities)
    text += fmt::format("{}{} [{}]", text.empty() ? "" : ",", quantity.name, si_unit(quantity));
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    char separator = '\n';
    for (const Quantity& quantity : quantities) {
      text += fmt::format("{}{:.17g}", separator, (history.*quantity.samples)[i]);
      separator = ',';
    }
  }
  mpm::replace_file(path, text + "\n");
}

TipHistory read_tip_trace_hdf5(const std::string& path) {
  const mpm::Hdf5File file = mpm::Hdf5File::open(path);
  TipHistory history;
  for (const Quantity& quantity : quantities) {
    const std::string dataset = std::string("/") + quantity.name;
    if (quantity.is_required || file.contains(dataset))
      history.*quantity.samples = file.read<double>(dataset);
  }
  complete_tip_history(history, path);
  return history;
}

void write_tip_trace_hdf5(const TipHistory& history, const std::string& path) {
  check_tip_history(history, path);
  mpm::Hdf5File file = mpm::Hdf5File::create_in_memory(path);
  for (const Quantity& quantity : quantities) {
    const std::string dataset = std::string("/") + quantity.name;
    file.write(dataset, history.*quantity.samples);
    file.write_attribute(dataset, "unit", si_unit(quantity));
  }
  mpm::replace_file(path, file.close_in_memory());
}

bool is_hdf5_trace(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".h5" || extension == ".hdf5";
}

TipHistory read_tip_trace(const std::string& path) {
  return is_hdf5_trace(path) ? read_tip_trace_hdf5(path) : read_tip_trace_csv(path);
}

}  // namespace zona::coupling
