#pragma once

#include <vector>

#include "studies/parameters/box.h"

namespace zona::studies {

/// A [[hold]]: nodes of the grid in a box, with a prescribed velocity.
struct Hold : BoxKeys {
  std::vector<int> axes;          ///< components of the velocity that are held
  std::vector<Formula> velocity;  ///< x, y, z of it [m/s], of place and time
};

/// The list [[hold]].
void declare_holds(Schema& schema);

}  // namespace zona::studies
