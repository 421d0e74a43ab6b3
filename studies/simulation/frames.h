#pragma once

#include "mpm/files/frame_writer.h"
#include "mpm/step/solver.h"

namespace zona::studies {

/// A point cloud of each body, SI units, points in the order of their ids. Membranes are triangles
/// with `failed`, `strain`, `damage`, `tension` (largest principal stress resultant [N/m]); fluids
/// have `pressure`; solids `pressure`, `equivalent_stress`, `plastic_strain`, `damage`; all but
/// rigid bodies `velocity`.
std::vector<mpm::PointCloud> point_clouds(const mpm::Solver& solver);

/// Cell averages of each fluid, "gas_cells" of the body "gas".
std::vector<mpm::CellFields> cell_fields(const mpm::Solver& solver);

}  // namespace zona::studies
