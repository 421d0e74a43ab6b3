#pragma once

#include <optional>

#include "mpm/step/solver.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// What [time] says of the step.
struct StepChoice {
  std::optional<double> step;  ///< [s]; empty: courant times the critical step
  double courant;              ///< fraction of the critical step [-]
};

/// Keys step and courant of [time], which must be open. `limit` is the interval of allowed steps
/// [s].
void declare_step(Schema& schema, const std::string& limit, const std::string& note);

/// The time step of a simulation and the longest stable one [s].
struct TimeStep {
  double seconds;
  double critical;
};

/// The step that [time] asks for, or at most `courant` of the critical step, so that a whole number
/// of steps meets `end` [s]. Throws InputError at the key for a step above the critical one, and
/// for "auto" where nothing limits the step.
TimeStep time_step(const Configuration& study, const mpm::Model& model, double end);

/// Whole steps of `step` that fit into `end` [s].
long step_count(double end, double step);

}  // namespace zona::studies
