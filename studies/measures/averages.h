#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "studies/input/table_keys.h"
#include "studies/measures/measured_bodies.h"

namespace zona::studies {

/// Averages over points at chosen times. A table with averages derives from this struct.
struct Averages {
  std::optional<std::vector<std::string>> bodies;  ///< averaged together; empty: all but rigid ones
  std::optional<std::vector<double>> times;        ///< [s]; empty: the end of the run
};

/// The key of the bodies.
template <class T>
void declare_averaged_bodies(TableKeys<T>& keys, const MeasuredBodies& bodies) {
  keys.declared("bodies", &Averages::bodies, bodies.declare_averaged);
}

/// The key of the times.
template <class T>
void declare_average_times(TableKeys<T>& keys) {
  keys.quantities("times", &Averages::times, "s", {})
      .in("[0, 1e6]")
      .auto_by_default()
      .doc("When; the step that is nearest counts. \"auto\" is the end.");
}

/// Complains of times after the end of the run and of rigid bodies.
template <class T>
void check_averages(const Table& table, const Complain& complain, const MeasuredBodies& measured) {
  std::optional<std::vector<double>> T::*times = &Averages::times;
  std::optional<std::vector<std::string>> T::*bodies = &Averages::bodies;
  const double end = measured.end(table.study());
  for (const double time : table.value(times).value_or(std::vector<double>{})) {
    if (time <= end) continue;
    complain(table.leaf(times),
             fmt::format("{:g} s is after the end of the run, {:g} s", time, end));
  }
  for (const std::string& name : table.value(bodies).value_or(std::vector<std::string>{})) {
    if (measured.substance(table.study(), name).material != MaterialName::rigid) continue;
    complain(table.leaf(bodies), fmt::format("{} is rigid: it has no stress to average", name));
  }
}

}  // namespace zona::studies
