#pragma once

#include "mpm/bodies/body.h"
#include "mpm/files/frame_writer.h"
#include "mpm/grid/background_grid.h"

namespace zona::mpm {

/// Averages of a fluid over the cells of its grid, which are far less noisy than its points:
/// `pressure` [Pa] by volume, `velocity` [m/s] by mass, `density` [kg/m^3] as mass over volume of
/// the points, and `points`, their number. NaN in cells without points. Throws ModelError for a
/// body that is not a fluid.
CellFields cell_averages(const Body& fluid, const BackgroundGrid& grid, const std::string& name);

}  // namespace zona::mpm
