#pragma once

#include "mpm/bodies/body.h"
#include "mpm/files/frame_writer.h"
#include "mpm/grid/background_grid.h"

namespace zona::mpm {

/// Averages of a fluid over the cells of its grid, which are far less noisy than its points:
/// `pressure` [Pa] by volume, `velocity` [m/s] by mass, `density` [kg/m^3], the mass of the points
/// over their volume, and `points`, their number; NaN in cells without points. Throws ModelError
/// for a body that is no fluid.
CellFields cell_averages(const Body& fluid, const BackgroundGrid& grid, const std::string& name);

}  // namespace zona::mpm
