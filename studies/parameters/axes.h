#pragma once

#include "studies/input/binding.h"

namespace zona::studies {

/// Words for the axes.
inline const Words<int> kAxisNames{{"x", 0}, {"y", 1}, {"z", 2}};

}  // namespace zona::studies
