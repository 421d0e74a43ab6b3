#pragma once

#include <string>
#include <vector>

#include "beam/motion/tip_history.h"
#include "beam/pipette/fluid.h"
#include "beam/pipette/pipette.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// The pipette of a study, filled with this fluid where [fill] says: GlassTube, Beam, FluidColumn
/// and Bath. Throws InputError for a pipette that is no beam, or a profile that cannot be read.
beam::Pipette pipette_from(const Configuration& study, const beam::Fluid& fill);

/// Warnings, with numbers, where the bath's load, that of a long cylinder with small motions far
/// from walls, does not hold for this motion of the tip. Empty without a bath.
std::vector<std::string> bath_warnings(const Configuration& study, const beam::TipHistory& history);

}  // namespace zona::studies
