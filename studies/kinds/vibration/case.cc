#include "studies/kinds/vibration/case.h"

#include <algorithm>
#include <cmath>

#include "beam/frequency/tip_response.h"
#include "beam/frequency/transfer_function.h"
#include "beam/system/natural_modes.h"
#include "beam/time/modal_stepper.h"
#include "studies/kinds/vibration/pulses_table.h"
#include "studies/kinds/vibration/sensitivity.h"
#include "studies/parameters/bath_table.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/beam_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"

namespace zona::studies {

namespace {

constexpr Eigen::Index reported_frequencies = 10;

void add_modes(FilledPipette& filled) {
  const beam::NaturalModes modes = beam::natural_modes(filled.system);
  const Eigen::Index count = std::min(modes.angular_frequency.size(), reported_frequencies);
  const beam::ModalOscillators lowest =
      beam::oscillators(filled.system, modes, static_cast<int>(count));
  for (Eigen::Index n = 0; n < count; ++n) {
    filled.natural_frequencies.push_back(lowest.angular_frequency(n) / (2 * M_PI));
    filled.damping_ratios.push_back(lowest.decay_rate(n) / lowest.angular_frequency(n));
  }
}

/// Time after which a motion of straight pieces stays at rest [s]; 0 for a sine.
double end_of_pulse(const beam::SupportMotion& motion) {
  const auto* pieces = std::get_if<beam::SampledMotion>(&motion);
  return pieces == nullptr ? 0 : pieces->time.back();
}

AxialResult axial_result(beam::TipHistory history, double support_peak) {
  const std::size_t farthest = beam::index_of_peak(history.displacement);
  return {beam::amplitude_ratio(history, support_peak), history.displacement[farthest],
          history.time[farthest], std::move(history)};
}

/// Extremes of the tip's motion, which result.history holds.
void add_tip_motion(VibrationResult& result, double support_peak) {
  const beam::TipHistory& history = result.history;
  const std::size_t farthest = beam::index_of_peak(history.displacement);
  const std::size_t fastest = beam::index_of_peak(history.velocity);
  result.amplitude_ratio = beam::amplitude_ratio(history, support_peak);
  result.peak_displacement = history.displacement[farthest];
  result.time_of_peak = history.time[farthest];
  result.peak_velocity = history.velocity[fastest];
  result.time_of_peak_velocity = history.time[fastest];
}

void add_sensitivities(VibrationResult& result, const PulseDirection& part,
                       const Configuration& study) {
  if (part.across != 0) result.sensitivities = beam_sensitivities(study, result.setup);
  if (part.along != 0)
    result.axial_sensitivities = beam_sensitivities(study, result.setup, Direction::along);
}

}  // namespace

std::vector<VibrationCase> vibration_cases(const Configuration& study) {
  const PulseShape shape = study.value(&Pulse::shape);
  const bool is_sine = shape == PulseShape::sine;
  const auto listed = study.value(is_sine ? &Pulses::angular_frequencies : &Pulses::durations);
  const auto pulses = shape == PulseShape::trace ? std::vector<double>{0} : listed;
  std::vector<VibrationCase> cases;
  for (const beam::Fluid& fluid : fills_of(study))
    for (const double pulse : pulses)
      cases.push_back({fluid, is_sine ? 0 : pulse, is_sine ? pulse : 0});
  return cases;
}

beam::SupportMotion support_motion_of(const VibrationCase& setup, const Configuration& study) {
  if (setup.angular_frequency > 0)
    return beam::SineMotion{study.read<Pulse>().support_peak(), setup.angular_frequency};
  return support_motion(study, setup.pulse_duration);
}

FilledPipette fill_pipette(const Configuration& study, const beam::Fluid& fluid) {
  const beam::Pipette pipette = pipette_from(study, fluid);
  const bool is_pinned = study.value(&Support::supports) == Supports::pinned;
  const auto integration = study.read<BeamIntegration>();
  FilledPipette filled;
  filled.system = is_pinned ? beam::simply_supported(pipette) : beam::cantilever(pipette);
  filled.integrator = integration.integrator_of(filled.system);
  add_modes(filled);
  if (std::holds_alternative<beam::Transform>(filled.integrator)) {
    filled.transfer =
        beam::TransferFunction(filled.system).at(beam::transform_points(integration.sampling()));
  }
  if (study.read<Pulse>().direction().along != 0) filled.rod = beam::axial_rod(pipette);
  return filled;
}

VibrationResult compute_case(const VibrationCase& setup, const FilledPipette& pipette,
                             const beam::Sampling& sampling, const Configuration& study) {
  VibrationResult result;
  result.setup = setup;
  result.natural_frequencies = pipette.natural_frequencies;
  result.damping_ratios = pipette.damping_ratios;
  const beam::SupportMotion support = support_motion_of(setup, study);
  const auto pulse = study.read<Pulse>();
  const PulseDirection part = pulse.direction();
  const beam::SupportMotion motion = part.along == 0 ? support : beam::scaled(support, part.across);
  const double peak = beam::peak_displacement(support);
  result.history = pipette.transfer.empty()
                       ? integrate(pipette.system, motion, sampling, pipette.integrator)
                       : beam::history_by_transform(pipette.transfer, motion, sampling);
  add_tip_motion(result, peak);
  // Without a quadratic drag the tip's motion is proportional to the support's.
  if (!pulse.peak && study.value(&Bath::drag_coefficient) == 0)
    result.gain_uncertainty = pulse.gain_uncertainty;
  result.ring_down = beam::ring_down(result.history, end_of_pulse(motion));
  result.residual_amplitude = beam::residual_amplitude(result.history);
  result.warnings = bath_warnings(study, result.history);
  if (pipette.rod)
    result.axial =
        axial_result(integrate(*pipette.rod, beam::scaled(support, part.along), sampling,
                               study.read<BeamIntegration>().integrator_of(*pipette.rod)),
                     peak);
  if (study.value(&VibrationOutput::sensitivities)) add_sensitivities(result, part, study);
  if (!study.value(&VibrationOutput::history)) {
    result.history = {};
    if (result.axial) result.axial->history = {};
  }
  return result;
}

}  // namespace zona::studies
