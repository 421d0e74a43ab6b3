#pragma once

#include "mpm/grid/background_grid.h"
#include "mpm/materials/fluid.h"
#include "mpm/step/solver.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// Choices of the scheme in every study of the material point method. The defaults are the
/// source's.
const Words<mpm::Interpolation>& interpolations();
const Words<mpm::EnergyIncrement>& energy_increments();
extern const char* const kInterpolationText;
extern const char* const kAverageVolumeText;
extern const char* const kEnergyIncrementText;

/// Keys of mpm::Numerics in [numerics], which must be open.
void declare_numerics(Schema& schema);

}  // namespace zona::studies
