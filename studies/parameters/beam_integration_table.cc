#include "studies/parameters/beam_integration_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/parameters/bath_table.h"
#include "studies/parameters/step_limits.h"

namespace zona::studies {

namespace {

const Words<IntegratorName> kIntegrators{{"newmark", IntegratorName::newmark},
                                         {"arkode", IntegratorName::arkode},
                                         {"modal", IntegratorName::modal},
                                         {"transform", IntegratorName::transform}};

void check_steps(const Configuration& study, const Complain& complain) {
  check_step(study.key(&BeamIntegration::step), study.value(&BeamIntegration::step),
             study.key(&BeamIntegration::end), study.value(&BeamIntegration::end), complain);
}

void check_bath(const Configuration& study, const Complain& complain) {
  const auto model = study.value(&Bath::model);
  const bool is_modal = study.value(&BeamIntegration::integrator) == IntegratorName::modal;
  const bool is_transform = study.value(&BeamIntegration::integrator) == IntegratorName::transform;
  if (model == beam::BathModel::none) return;
  const std::string integrator_key = study.key(&BeamIntegration::integrator);
  if (model == beam::BathModel::per_mode && !is_modal)
    complain(study.key(&Bath::model),
             fmt::format("per_mode is for {} = \"modal\"; choose that, or model = \"frequency\"",
                         integrator_key));
  if (model != beam::BathModel::per_mode && is_modal)
    complain(integrator_key,
             fmt::format("modal superposition takes {} = \"per_mode\" only; choose that, or "
                         "integrator \"transform\" or \"newmark\" for \"{}\"",
                         study.key(&Bath::model), word_for(bath_models(), model)));
  if (study.value(&Bath::drag_coefficient) > 0 && (is_modal || is_transform))
    complain(study.key(&Bath::drag_coefficient),
             "a quadratic drag is not linear; it needs the integrator \"newmark\" or \"arkode\"");
}

}  // namespace

void declare_beam_integration(Schema& schema, const std::string& section, IntegratorName preset) {
  TableKeys<BeamIntegration> keys(schema, section);
  keys.quantity("end", &BeamIntegration::end, "s", "5 ms")
      .in("(0, 10]")
      .doc("End of the simulation, from the start of the pulse (5.5).");
  keys.quantity("step", &BeamIntegration::step, "s", "0.6 us")
      .in("(0, 1]")
      .called("Delta t")
      .doc("Time step of Newmark's method and spacing of the recorded history (5.5).");
  keys.choice("integrator", &BeamIntegration::integrator, kIntegrators, preset)
      .doc(
          "Newmark with average acceleration (as the source), SUNDIALS ARKODE with error control, "
          "modal superposition, which is exact in time for pulses with straight pieces, or the "
          "inverse transform of the response to every frequency, which is exact for a bath, too. "
          "It also takes the place of modal superposition for the motion along a filled pipette, "
          "whose fluid lags differently at every frequency, unless bath.model is \"per_mode\".");
  keys.number("relative_tolerance", &BeamIntegration::relative_tolerance, 1e-6)
      .in("(0, 1)")
      .doc("Relative error per step that arkode allows; the others ignore it.");
  keys.quantity("absolute_tolerance", &BeamIntegration::absolute_tolerance, "m", "1e-12 m")
      .in("(0, 1]")
      .doc("Absolute error of a deflection per step that arkode allows; the others ignore it.");
  schema.check(check_steps);
  schema.check(check_bath);
}

beam::Integrator BeamIntegration::integrator_of(const beam::BeamSystem& system) const {
  switch (integrator) {
    case IntegratorName::newmark:
      return beam::Newmark{};
    case IntegratorName::transform:
      return beam::Transform{};
    case IntegratorName::modal: {
      // The load of the bore's fluid at the mode's frequency would be a poor approximation.
      const auto& loads = system.liquids.viscous;
      const bool is_filled_rod = std::any_of(loads.begin(), loads.end(), [](const auto& load) {
        return load.flow == beam::Flow::within;
      });
      if (is_filled_rod && !system.liquids.has_bath(beam::BathModel::per_mode))
        return beam::Transform{};
      return beam::Modal{};
    }
    case IntegratorName::arkode:
      break;
  }
  // Maxwell elements relax within nanoseconds.
  const bool is_stiff = system.damping_beta > 0 || system.loss_factor > 0 || system.liquids.act();
  const auto method = is_stiff ? beam::RungeKutta::implicit_5 : beam::RungeKutta::explicit_8;
  return beam::Arkode{relative_tolerance, absolute_tolerance, method};
}

}  // namespace zona::studies
