#pragma once

#include <functional>
#include <string>

#include "mpm/step/solver.h"
#include "studies/simulation/solver_march.h"

namespace zona::studies {

/// What a simulation will take on this machine, from trying its first steps.
struct Trial {
  double seconds;  ///< of the whole run
  double own;      ///< memory that another one beside it would take [bytes]
  double memory;   ///< of the program at its peak, when it stores a checkpoint [bytes]
  double disk;     ///< frames and two checkpoints [bytes]
  long frames;
  double tried;  ///< how long steps were tried [s]
};

/// Steps a model for up to a second.
Trial try_simulation(mpm::Model model, double step, double end, const OutputPlan& plan,
                     int threads);

/// The trial in a line or two, with a warning where memory will not suffice, or where a point goes
/// wrong at once.
std::string trial_text(const std::function<Trial()>& trial, int threads);

}  // namespace zona::studies
