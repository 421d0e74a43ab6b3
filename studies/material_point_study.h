#pragma once

#include <array>
#include <string>
#include <vector>

#include "mpm/single_point.h"
#include "studies/configuration.h"
#include "studies/study_kinds.h"

namespace zona::studies {

/// Names of the components of mpm::SymmetricTensor, in its order.
inline constexpr std::array<const char*, 6> strain_components{"xx", "yy", "zz", "xy", "yz", "zx"};

/// Strains at the ends of the segments of a material_point study; zero for free components.
std::vector<mpm::SymmetricTensor> path_strains(const Configuration& study);

/// The point that the study describes, at rest. Throws mpm::ModelError.
mpm::SinglePoint material_point(const Configuration& study);

/// Finds what the model refuses; the job writes history.csv and the results.
Job prepare_material_point(const Configuration& study);

/// The size of the study.
StudyCost estimate_material_point(const Configuration& study);

}  // namespace zona::studies
