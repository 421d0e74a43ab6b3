#pragma once

#include "mpm/background_grid.h"
#include "mpm/body.h"
#include "mpm/frame_writer.h"

namespace zona::mpm {

/// Averages of a fluid over the cells of its grid, which are far less noisy than its points:
/// `pressure` [Pa] by volume, `velocity` [m/s] by mass, `density` [kg/m^3], the mass of the points
/// over their volume, and `points`, their number; NaN in cells without points. Throws ModelError
/// for a body that is no fluid.
CellFields cell_averages(const Body& fluid, const BackgroundGrid& grid, const std::string& name);

}  // namespace zona::mpm
