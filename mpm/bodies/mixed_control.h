#pragma once

#include "mpm/bodies/single_point.h"

namespace zona::mpm {

/// Free components: their stress is zero, and their strain follows from that.
using FreeComponents = std::array<bool, 6>;

/// One step of mixed control: strains the point to `target` in the components that are not free and
/// finds the strains of the others for which their stress is zero. Uses Newton's method with finite
/// differences, and divides the step where that does not converge. Returns the largest remaining
/// stress of a free component [Pa].
double step_to(SinglePoint& point, const SymmetricTensor& target, const FreeComponents& free);

}  // namespace zona::mpm
