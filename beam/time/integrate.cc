#include "beam/time/integrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam/algebra/require.h"
#include "beam/frequency/transfer_function.h"
#include "beam/system/natural_modes.h"
#include "beam/time/arkode_stepper.h"
#include "beam/time/march.h"
#include "beam/time/modal_stepper.h"
#include "beam/time/newmark_stepper.h"

namespace zona::beam {
namespace {

/// Frequencies that the samples resolve: from a tenth of a period over all samples to half the
/// sampling frequency.
FrequencySpan span_of(const Sampling& sampling) {
  return {0.1 * 2 * M_PI / sampling.end, std::max(M_PI / sampling.step, 2 * M_PI / sampling.end)};
}

TipHistory integrate_with(const Newmark& newmark, const BeamSystem& system,
                          const SupportMotion& motion, const Sampling& sampling) {
  require(newmark.steps_per_sample >= 1,
          fmt::format("newmark: {} steps per sample, but at least 1 is needed",
                      newmark.steps_per_sample));
  NewmarkStepper stepper(system, motion, sampling.step / newmark.steps_per_sample,
                         span_of(sampling));
  return march(system.support_share, motion, sampling, stepper);
}

TipHistory integrate_with(const Modal& modal, const BeamSystem& system, const SupportMotion& motion,
                          const Sampling& sampling) {
  require(
      modal.modes >= 0 && modal.modes <= system.size(),
      fmt::format("modal superposition: {} modes, but this mesh has {}; use 0 for all or refine "
                  "the mesh",
                  modal.modes, system.size()));
  require(!system.liquids.has_bath(BathModel::frequency) &&
              !system.liquids.has_bath(BathModel::constant) && system.liquids.drag.empty(),
          "modal superposition: a bath needs the model per_mode, without quadratic drag; choose "
          "these, or another integrator");
  const int count = modal.modes == 0 ? system.size() : modal.modes;
  ModalStepper stepper(oscillators(system, natural_modes(system), count), motion, sampling.step);
  return march(system.support_share, motion, sampling, stepper);
}

TipHistory integrate_with(const Arkode& arkode, const BeamSystem& system,
                          const SupportMotion& motion, const Sampling& sampling) {
  require(is_positive(arkode.relative_tolerance) && is_positive(arkode.absolute_tolerance),
          fmt::format("arkode: tolerances {} (relative) and {} m (absolute), but both must be "
                      "greater than 0; 1e-6 and 1e-11 m suit the default pipette",
                      arkode.relative_tolerance, arkode.absolute_tolerance));
  ArkodeStepper stepper(system, motion, arkode, span_of(sampling));
  return march(system.support_share, motion, sampling, stepper);
}

TipHistory integrate_with(const Transform&, const BeamSystem& system, const SupportMotion& motion,
                          const Sampling& sampling) {
  return integrate_by_transform(system, motion, sampling);
}

}  // namespace

TipHistory integrate(const BeamSystem& system, const SupportMotion& motion,
                     const Sampling& sampling, const Integrator& integrator) {
  check(motion);
  return std::visit(
      [&](const auto& chosen) { return integrate_with(chosen, system, motion, sampling); },
      integrator);
}

}  // namespace zona::beam
