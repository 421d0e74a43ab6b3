#pragma once

#include <nlohmann/json_fwd.hpp>

#include "studies/input/configuration.h"
#include "studies/kinds/vibration/result.h"

namespace zona::studies {

/// Direction of the tip's motion relative to the pipette.
enum class Direction { across, along };

/// Derivatives of a vibration case's motion in one direction with respect to every input that has
/// an effect: quantities and numbers of [pipette], [fill], [[column]], [bath] and [pulse] that are
/// neither zero nor "auto", the fluid's density and viscosity and the pulse's duration. Inputs of
/// the beam by forward sensitivity analysis (`transfer_sensitivity`), those of the pulse in closed
/// form. Throws std::invalid_argument for a sine, a quadratic drag and BathModel::per_mode.
SensitivityResult beam_sensitivities(const Configuration& study, const VibrationCase& setup,
                                     Direction direction = Direction::across);

/// The response without derivatives.
SensitivityResult beam_response(const Configuration& study, const VibrationCase& setup,
                                Direction direction = Direction::across);

nlohmann::json to_json(const SensitivityResult& result);

}  // namespace zona::studies
