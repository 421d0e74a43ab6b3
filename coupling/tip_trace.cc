#include "coupling/tip_trace.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "coupling/slopes.h"
#include "mpm/files/atomic_file.h"
#include "mpm/files/hdf5_file.h"

namespace zona::coupling {

namespace {

using beam::TipHistory;

struct Quantity {
  const char* name;
  const char* unit;
  std::vector<double> TipHistory::*samples;
};

constexpr std::array<Quantity, 5> quantities{{{"time", "s", &TipHistory::time},
                                              {"displacement", "m", &TipHistory::displacement},
                                              {"velocity", "m/s", &TipHistory::velocity},
                                              {"acceleration", "m/s^2", &TipHistory::acceleration},
                                              {"support", "m", &TipHistory::support}}};

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

TraceError::TraceError(const std::string& file, std::size_t line, std::size_t column,
                       const std::string& problem)
    : std::runtime_error(line == 0 ? fmt::format("{}: {}", file, problem)
                                   : fmt::format("{}:{}:{}: {}", file, line, column, problem)),
      line_(line),
      column_(column) {}

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
    text += fmt::format("{}{} [{}]", text.empty() ? "" : ",", quantity.name, quantity.unit);
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
    const bool required =
        quantity.samples == &TipHistory::time || quantity.samples == &TipHistory::displacement;
    if (required || file.contains(dataset)) history.*quantity.samples = file.read<double>(dataset);
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
    file.write_attribute(dataset, "unit", quantity.unit);
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
