#pragma once

#include "mpm/bodies/single_point.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// The point that a material_point study describes, at rest. Throws mpm::ModelError.
mpm::SinglePoint material_point(const Configuration& study);

}  // namespace zona::studies
