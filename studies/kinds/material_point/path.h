#pragma once

#include <array>
#include <vector>

#include "mpm/bodies/mixed_control.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// Names of the components of mpm::SymmetricTensor, in its order.
inline constexpr std::array<const char*, 6> strain_components{"xx", "yy", "zz", "xy", "yz", "zx"};

/// Which components a material_point study leaves free.
mpm::FreeComponents free_components(const Configuration& study);

/// Strains at the ends of the segments of a material_point study; zero for free components.
std::vector<mpm::SymmetricTensor> path_strains(const Configuration& study);

}  // namespace zona::studies
