#pragma once

#include "mpm/grid/background_grid.h"
#include "studies/input/binding.h"

namespace zona::studies {

/// Words for the conditions at a face of the grid.
inline const Words<mpm::FaceCondition> kFaceConditions{
    {"free", mpm::FaceCondition::free},
    {"roller", mpm::FaceCondition::roller},
    {"fixed", mpm::FaceCondition::fixed},
    {"absorbing", mpm::FaceCondition::absorbing}};

}  // namespace zona::studies
