#pragma once

#include "studies/input/table_keys.h"

namespace zona::studies {

/// The background grid of a piercing.
struct Grid {
  double cell;    ///< edge of the cubic cells [m]
  double domain;  ///< edge of the cubic domain, rounded up to whole cells [m]
};

/// The section [grid]. Complains of too many cells.
void declare_grid(Schema& schema);

}  // namespace zona::studies
