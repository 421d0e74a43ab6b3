#pragma once

#include "mpm/bodies/single_point.h"

namespace zona::mpm {

/// Which components are free: their strain follows from their stress being zero.
using FreeComponents = std::array<bool, 6>;

/// One step of mixed control: the point goes to `target` in the components that are not free, and
/// to whatever frees the others of stress (Newton's method with differences; where it does not
/// come to an end, in parts of the step). Returns the greatest stress that was left in them [Pa].
double step_to(SinglePoint& point, const SymmetricTensor& target, const FreeComponents& free);

}  // namespace zona::mpm
