#pragma once

#include <string>

#include "mpm/step/solver.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// The time step of a simulation.
struct TimeStep {
  double seconds;       ///< [s]
  double critical;      ///< the longest stable one [s]; infinite without a limit
  std::string binding;  ///< what decides the step, for a message
};

/// The step that [time] asks for, or at most `courant` of the critical step and, with implicit
/// pressure, `travel` of a cell of the fastest motion, so that a whole number of steps meets `end`
/// [s]. Motion is prescribed, or that of the points at the start and of a fall through the grid.
/// Throws InputError at the key for a step above the critical one, for one in which the motion
/// travels more than half a cell, and for "auto" where nothing limits the step.
TimeStep time_step(const Configuration& study, const mpm::Model& model, double end);

/// Whole steps of `step` that fit into `end` [s].
long step_count(double end, double step);

}  // namespace zona::studies
