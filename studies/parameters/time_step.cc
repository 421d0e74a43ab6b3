#include "studies/parameters/time_step.h"

#include <fmt/format.h>

#include <cmath>

#include "studies/parameters/step_table.h"

namespace zona::studies {

TimeStep time_step(const Configuration& study, const mpm::Model& model, double end) {
  const auto refuse = [&](const std::string& message) {
    return InputError(study.problem(&StepChoice::step, message));
  };
  const auto critical = mpm::critical_step(model.grid, model.bodies);
  const auto choice = study.read<StepChoice>();
  if (!choice.step) {
    if (!std::isfinite(critical.seconds)) {
      throw refuse(
          "nothing limits the step, because no body has waves; give one, e.g. step = \"1 us\"");
    }
    const double longest = choice.courant * critical.seconds;
    return {end / std::ceil(end / longest), critical.seconds};
  }
  const double step = *choice.step;
  if (step > critical.seconds) {
    throw refuse(
        fmt::format("{:.4g} ns is above the critical step of {:.4g} ns ({} of '{}'); choose at "
                    "most that, or \"auto\"",
                    step * 1e9, critical.seconds * 1e9, critical.reason, critical.body));
  }
  return {step, critical.seconds};
}

long step_count(double end, double step) {
  return static_cast<long>(std::floor(end / step + 1e-6));
}

}  // namespace zona::studies
