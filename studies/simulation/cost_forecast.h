#pragma once

#include <functional>
#include <string>

#include "mpm/step/solver.h"
#include "studies/simulation/output_plan.h"

namespace zona::studies {

/// Time, memory and disk that a simulation will take on this machine, extrapolated from its first
/// steps.
struct CostForecast {
  double seconds;     ///< of the whole run
  double own_memory;  ///< of this simulation alone [bytes]
  double memory;      ///< of the program at its peak, when it stores a checkpoint [bytes]
  double disk;        ///< frames and two checkpoints [bytes]
  long frames;
  double tried;  ///< time of the steps that the forecast rests on [s]
};

/// Steps a model for up to a second. `step` and `end` in s. Throws mpm::StepError when a point
/// fails in these steps.
CostForecast forecast_cost(mpm::Model model, double step, double end, const OutputPlan& plan,
                           int threads);

/// A forecast in a line or two, with a warning where memory will not suffice, or where `forecast`
/// throws mpm::StepError.
std::string forecast_text(const std::function<CostForecast()>& forecast, int threads);

}  // namespace zona::studies
