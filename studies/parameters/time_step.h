#pragma once

#include "mpm/step/solver.h"
#include "studies/input/configuration.h"

namespace zona::studies {

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
