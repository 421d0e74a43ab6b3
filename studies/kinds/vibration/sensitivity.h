#pragma once

#include <nlohmann/json_fwd.hpp>

#include "studies/input/configuration.h"
#include "studies/kinds/vibration/result.h"

namespace zona::studies {

/// Which motion of the tip: that across the pipette or that along it.
enum class Direction { across, along };

/// Derivatives of a vibration case's motion in one direction by every input that acts: quantities
/// and numbers of [pipette], [fill], [[column]], [bath] and [pulse] that are neither zero nor
/// "auto", the fluid's density and viscosity and the pulse's duration. Beam inputs by forward
/// sensitivity analysis (`transfer_sensitivity`), the pulse's in closed form. Throws
/// std::invalid_argument for a sine, a quadratic drag and BathModel::per_mode.
SensitivityResult beam_sensitivities(const Configuration& study, const VibrationCase& setup,
                                     Direction direction = Direction::across);

/// The response alone, without `inputs`.
SensitivityResult beam_response(const Configuration& study, const VibrationCase& setup,
                                Direction direction = Direction::across);

nlohmann::json to_json(const SensitivityResult& result);

}  // namespace zona::studies
