#pragma once

#include "mpm/grid/cell.h"

namespace zona::mpm {

/// Up to eight points from several sparsely filled cells of a brick. Work on points still uses all
/// eight lanes; the nodes are visited point by point.
struct Batch {
  PointGroup group;                    ///< the points
  std::array<Lanes, 3> corner;         ///< lowest corner of each point's cell [m]
  std::array<double, 3> inverse;       ///< 1 / cell size [1/m]
  std::array<int, lane_count> node{};  ///< lowest node of each point's cell
  std::array<int, lane_count> cell{};  ///< number of each point's cell in the brick

  /// `count` points, at least 1, and the number of each one's cell in the brick.
  Batch(const BackgroundGrid& grid, const Brick& brick, const int* points, const int* cells,
        int count)
      : group(points, count), corner{}, inverse(grid.inverse_cell_size()) {
    double corners[3][lane_count];
    for (int l = 0; l < lane_count; ++l) {
      cell[l] = cells[l < count ? l : 0];
      const Cell c = make_cell(grid, brick, cell[l]);
      node[l] = c.first_node;
      for (int axis = 0; axis < 3; ++axis) corners[axis][l] = c.corner[axis];
    }
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] = each_lane([&](int l) { return corners[axis][l]; });
  }
  /// Natural coordinates of the points in [0, 1], each in its cell.
  std::array<Lanes, 3> natural(const std::array<Lanes, 3>& position) const {
    return {(position[0] - corner[0]) * inverse[0], (position[1] - corner[1]) * inverse[1],
            (position[2] - corner[2]) * inverse[2]};
  }
};

/// Collects points of sparsely filled cells and calls f(Batch) whenever it has eight.
template <class F>
class Batches {
 public:
  /// For the cells of brick b.
  Batches(const BackgroundGrid& grid, int b, F f) : grid_(grid), brick_(grid.bricks()[b]), f_(f) {}

  /// Takes the points [begin, end) of a cell of the brick.
  void add(const int* begin, const int* end, int cell) {
    for (; begin < end; ++begin) {
      points_[count_] = *begin;
      cells_[count_++] = cell;
      if (count_ == lane_count) flush();
    }
  }
  /// Calls f for the remaining points; must be called at the end.
  void flush() {
    if (count_ > 0) f_(Batch(grid_, brick_, points_, cells_, count_));
    count_ = 0;
  }

 private:
  const BackgroundGrid& grid_;
  const Brick& brick_;
  F f_;
  int points_[lane_count];
  int cells_[lane_count];
  int count_ = 0;
};

/// Calls on_cell(Cell, begin, end, cell_in_brick) for each cell of a brick with more than `few`
/// points, and on_batch(Batch) for the points of the other cells, in the order of cells.
template <class OnCell, class OnBatch>
void for_each_cell_or_batch(const BackgroundGrid& grid, int b, const BrickPoints& points, int few,
                            OnCell on_cell, OnBatch on_batch) {
  Batches<OnBatch> batches(grid, b, on_batch);
  for (int c = 0; c < Brick::cell_count; ++c) {
    const int* begin = points.points.data() + points.begin[c];
    const int* end = points.points.data() + points.begin[c + 1];
    if (end - begin <= few) {
      batches.add(begin, end, c);
    } else {
      batches.flush();
      on_cell(make_cell(grid, grid.bricks()[b], c), begin, end, c);
    }
  }
  batches.flush();
}

}  // namespace zona::mpm
