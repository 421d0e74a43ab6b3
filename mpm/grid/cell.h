#pragma once

#include "mpm/grid/cell_index.h"
#include "mpm/points/material_points.h"

namespace zona::mpm {

/// Geometry and nodes of a cell, for the kernels.
struct Cell {
  std::array<double, 3> corner;   ///< [m]
  std::array<double, 3> inverse;  ///< 1 / cell size [1/m]
  int first_node;                 ///< the lowest of its nodes
  std::array<int, 3> index;       ///< along each axis of the grid

  /// Natural coordinates of eight points in [0, 1].
  std::array<Lanes, 3> natural(const std::array<Lanes, 3>& position) const {
    return {(position[0] - corner[0]) * inverse[0], (position[1] - corner[1]) * inverse[1],
            (position[2] - corner[2]) * inverse[2]};
  }
};

/// The cell with the number `cell_in_brick` in a brick.
inline Cell make_cell(const BackgroundGrid& grid, const Brick& brick, int cell_in_brick) {
  constexpr int e = Brick::edge;
  const std::array<int, 3> index{brick.first_cell[0] + cell_in_brick % e,
                                 brick.first_cell[1] + cell_in_brick / e % e,
                                 brick.first_cell[2] + cell_in_brick / (e * e)};
  Cell cell{{}, grid.inverse_cell_size(), grid.node_index(index[0], index[1], index[2]), index};
  for (int axis = 0; axis < 3; ++axis)
    cell.corner[axis] = grid.origin()[axis] + index[axis] * grid.cell_size()[axis];
  return cell;
}

/// Calls f(Cell, begin, end, cell_in_brick) for each cell of a brick that holds points.
template <class F>
void for_each_cell(const BackgroundGrid& grid, int b, const BrickPoints& points, F f) {
  for (int c = 0; c < Brick::cell_count; ++c) {
    const int begin = points.begin[c];
    const int end = points.begin[c + 1];
    if (begin < end)
      f(make_cell(grid, grid.bricks()[b], c), points.points.data() + begin,
        points.points.data() + end, c);
  }
}

/// Contributions of a group of points to the nodes of its cell: a row per quantity, a column per
/// point.
struct PointContributions {
  alignas(64) double natural[3][lane_count];    ///< coordinates in the cell, 0 to 1 [-]
  alignas(64) double mass[lane_count];          ///< [kg]
  alignas(64) double momentum[3][lane_count];   ///< [kg m/s]
  alignas(64) double stress[3][3][lane_count];  ///< -volume sigma_ij / cell size_j [N]
};

/// One vector per point of a group, in the same layout.
struct PointVectors {
  alignas(64) double natural[3][lane_count];  ///< coordinates in the cell, 0 to 1 [-]
  alignas(64) double vector[3][lane_count];   ///< its components
};

}  // namespace zona::mpm
