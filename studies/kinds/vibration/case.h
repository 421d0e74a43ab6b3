#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "beam/system/beam_system.h"
#include "beam/time/integrate.h"
#include "studies/input/configuration.h"
#include "studies/kinds/vibration/result.h"

namespace zona::studies {

/// All fluids with all pulses, fluid by fluid, in the order of the study.
std::vector<VibrationCase> vibration_cases(const Configuration& study);

/// Motion of the support in a case. Throws InputError where the study does not describe one.
beam::SupportMotion support_motion_of(const VibrationCase& setup, const Configuration& study);

/// Beam with its modes and transfer function, which all cases with the same fluid share.
struct FilledPipette {
  beam::BeamSystem system;
  beam::Integrator integrator;
  std::vector<double> natural_frequencies{};
  std::vector<double> damping_ratios{};
  /// Transfer function at beam::transform_points; only for the integrator "transform".
  std::vector<std::complex<double>> transfer{};
  /// Only where the support moves along the pipette, too.
  std::optional<beam::BeamSystem> rod{};
};

/// Throws InputError for a pipette that cannot be.
FilledPipette fill_pipette(const Configuration& study, const beam::Fluid& fluid);

VibrationResult compute_case(const VibrationCase& setup, const FilledPipette& pipette,
                             const beam::Sampling& sampling, const Configuration& study);

}  // namespace zona::studies
