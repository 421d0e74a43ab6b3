#pragma once

#include "mpm/grid/quadratic.h"
#include "mpm/grid/trilinear.h"

namespace zona::mpm {

/// Calls f(Trilinear{}) or f(Quadratic{}), the policy of the grid's interpolation. The kernels of
/// the step are templates on it. A policy has these types, each constructed from a grid and one of
/// its cells:
///
/// - `NodalSums`: mass, momentum and internal force, points to nodes;
/// - `VectorSums`: one vector of each point, points to nodes;
/// - `CellField`: velocity and acceleration, nodes to points;
/// - `CellGradient`: velocity gradient, nodes to points.
template <class F>
decltype(auto) with_shape_functions(const BackgroundGrid& grid, F f) {
  if (grid.interpolation() == Interpolation::quadratic) return f(Quadratic{});
  return f(Trilinear{});
}

}  // namespace zona::mpm
