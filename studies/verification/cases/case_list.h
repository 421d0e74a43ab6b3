#pragma once

#include <vector>

#include "studies/verification/evaluation/verification_case.h"

namespace zona::studies::verification {

// Chapter 3
std::vector<Case> solids();
// Chapter 4
std::vector<Case> gas_dynamics();
std::vector<Case> chapter_four();
// Chapter 5
std::vector<Case> material_points();
std::vector<Case> boundaries();
std::vector<Case> injection();
std::vector<Case> piercing();
std::vector<Case> pipette();
std::vector<Case> pipette_bath();
// What the source lacks
std::vector<Case> membranes();
std::vector<Case> flows();
// Choices of the scheme
std::vector<Case> numerics();

}  // namespace zona::studies::verification
