#pragma once

#include "mpm/grid/background_grid.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// The background grid of box-shaped cells.
struct SceneGrid {
  Eigen::Vector3d low{0, 0, 0};   ///< lowest corner [m]
  Eigen::Vector3d high{0, 0, 0};  ///< highest corner [m]
  Eigen::Vector3d cell{0, 0, 0};  ///< edges of a cell [m]
  mpm::Interpolation interpolation;

  mpm::BackgroundGrid grid() const;
};

/// The section [grid]. Complains of cells that do not fill it and of too many.
void declare_scene_grid(Schema& schema);

}  // namespace zona::studies
