#pragma once

#include "mpm/grid/background_grid.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// Conditions at the faces of the grid.
struct SceneBoundary {
  mpm::FaceCondition x_low, x_high, y_low, y_high, z_low, z_high;

  mpm::FaceConditions faces() const { return {x_low, x_high, y_low, y_high, z_low, z_high}; }
};

/// The section [boundary].
void declare_scene_boundary(Schema& schema);

}  // namespace zona::studies
