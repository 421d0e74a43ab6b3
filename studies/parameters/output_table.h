#pragma once

#include <optional>
#include <string>

#include "studies/input/table_keys.h"

namespace zona::studies {

/// Output of a simulation.
struct Output {
  std::optional<double> history_interval;  ///< between rows of history.csv [s]; empty: end / 500
  std::optional<double> fields_interval;   ///< between frames [s]; empty: end / 20
  bool fields;                             ///< whether there are frames
};

/// The section [output]. Each interval has a default, a note that follows its text, and a limit
/// [s].
struct IntervalKey {
  std::string preset;
  std::string limit;
  std::string note;
};
void declare_output(Schema& schema, const IntervalKey& history, const IntervalKey& fields);

}  // namespace zona::studies
