#pragma once

#include "mpm/frame_writer.h"
#include "mpm/solver.h"

namespace zona::studies {

/// All bodies of a solver as they are drawn, points in the order of their ids: the zona's triangles
/// with `failed`, `strain`, `damage` and `velocity`, fluids with `pressure` and `velocity`, rigid
/// bodies bare.
std::vector<mpm::PointCloud> draw(const mpm::Solver& solver);

}  // namespace zona::studies
