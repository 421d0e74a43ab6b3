#pragma once

#include <optional>
#include <string>

#include "studies/input/table_keys.h"

namespace zona::studies {

/// The step of [time].
struct StepChoice {
  std::optional<double> step;  ///< [s]; empty: courant times the critical step
  double courant;              ///< fraction of the critical step [-]
  double travel;               ///< of prescribed motion in a step with implicit pressure [cells]
};

/// Keys step, courant and travel of [time], which must be open. `limit` is the interval of allowed
/// steps [s].
void declare_step(Schema& schema, const std::string& limit, const std::string& note);

}  // namespace zona::studies
