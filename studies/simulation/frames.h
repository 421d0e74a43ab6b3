#pragma once

#include "mpm/files/frame_writer.h"
#include "mpm/step/solver.h"

namespace zona::studies {

/// All bodies of a solver as they are drawn, points in the order of their ids: membranes as
/// triangles with `failed`, `strain`, `damage`, `tension` (largest principal stress resultant
/// [N/m]); fluids with `pressure`; solids with `pressure`, `equivalent_stress`, `plastic_strain`,
/// `damage`; all with `velocity` but rigid bodies, which are bare.
std::vector<mpm::PointCloud> draw(const mpm::Solver& solver);

/// Cell averages of all fluids, "gas_cells" of the body "gas".
std::vector<mpm::CellFields> draw_cells(const mpm::Solver& solver);

}  // namespace zona::studies
