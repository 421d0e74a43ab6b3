#include "mpm/grid/background_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mpm/points/errors.h"

namespace zona::mpm {

BackgroundGrid::BackgroundGrid(const Eigen::Vector3d& origin, const Eigen::Vector3d& cell_size,
                               const std::array<int, 3>& cells, Interpolation interpolation)
    : origin_(origin),
      cell_size_(cell_size),
      inverse_cell_size_{1 / cell_size[0], 1 / cell_size[1], 1 / cell_size[2]},
      characteristic_length_(std::cbrt(cell_size.prod())),
      cells_(cells),
      interpolation_(interpolation) {
  const int per_axis = interpolation == Interpolation::quadratic ? 3 : 2;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(cell_size[axis] > 0) || cells[axis] < 1) {
      throw ModelError(
          fmt::format("a grid needs at least one cell of positive size along each "
                      "axis, got {} cells of {} m",
                      cells[axis], cell_size[axis]));
    }
    nodes_along_[axis] = cells[axis] + per_axis - 1;
    bricks_along_[axis] = (cells[axis] + Brick::edge - 1) / Brick::edge;
  }
  for (int n = 0; n < nodes_per_cell(); ++n) {
    node_offsets_[n] = node_index(n % per_axis, n / per_axis % per_axis, n / (per_axis * per_axis));
  }
  for (int k = 0; k < bricks_along_[2]; ++k) {
    for (int j = 0; j < bricks_along_[1]; ++j) {
      for (int i = 0; i < bricks_along_[0]; ++i) {
        by_colour_[(k % 2 * 2 + j % 2) * 2 + i % 2].push_back(static_cast<int>(bricks_.size()));
        Brick brick{{i * Brick::edge, j * Brick::edge, k * Brick::edge}, {}};
        for (int axis = 0; axis < 3; ++axis) {
          brick.size[axis] = std::min(Brick::edge, cells[axis] - brick.first_cell[axis]);
        }
        bricks_.push_back(brick);
      }
    }
  }
  const std::size_t nodes =
      static_cast<std::size_t>(nodes_along_[0]) * nodes_along_[1] * nodes_along_[2];
  state.assign(nodes, Lanes{});
  updated.assign(nodes, HalfLanes{});
}

Eigen::Vector3d BackgroundGrid::upper_corner() const {
  return origin_ + cell_size_.cwiseProduct(Eigen::Vector3d(cells_[0], cells_[1], cells_[2]));
}

Eigen::Vector3d BackgroundGrid::node_position(int i, int j, int k) const {
  Eigen::Vector3d cells(i, j, k);
  if (interpolation_ == Interpolation::quadratic) {
    for (int axis = 0; axis < 3; ++axis)
      cells[axis] = std::clamp(cells[axis] - 0.5, 0.0, static_cast<double>(cells_[axis]));
  }
  return origin_ + cell_size_.cwiseProduct(cells);
}

std::array<int, 3> BackgroundGrid::cell_at(double x, double y, double z) const {
  const double place[3] = {x, y, z};
  std::array<int, 3> cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double s = (place[axis] - origin_[axis]) / cell_size_[axis];
    if (!(s >= 0 && s < cells_[axis])) return {-1, -1, -1};
    cell[axis] = static_cast<int>(s);
  }
  return cell;
}

int BackgroundGrid::brick_of(const std::array<int, 3>& cell) const {
  return (cell[2] / Brick::edge * bricks_along_[1] + cell[1] / Brick::edge) * bricks_along_[0] +
         cell[0] / Brick::edge;
}

int BackgroundGrid::cell_in_brick(const std::array<int, 3>& cell) {
  return (cell[2] % Brick::edge * Brick::edge + cell[1] % Brick::edge) * Brick::edge +
         cell[0] % Brick::edge;
}

}  // namespace zona::mpm
