#pragma once

#include <array>
#include <vector>

#include "mpm/grid/background_grid.h"

namespace zona::mpm {

/// A point that is about to leave a cell.
struct Departure {
  int point;  ///< its place in the storage
  int cell;   ///< the cell it is listed in, within its brick
};

/// The points of one body in one brick, cell by cell; within a cell in ascending order.
struct BrickPoints {
  std::vector<int> points;                         ///< places in the storage
  std::array<int, Brick::cell_count + 1> begin{};  ///< where each cell's points start in `points`
  std::vector<Departure> departures;               ///< filled while points move
  std::vector<int> arrivals;                       ///< ascending; of the last `move_departed`

  bool empty() const { return points.empty(); }  ///< no point of the body is in the brick
  /// @{
  /// Enters a point into a cell of the brick, or takes it out.
  void insert(int cell, int point);
  void erase(int cell, int point);
  /// @}
};

/// Which points of a body lie in which cell. Kept up to date point by point as they cross cells,
/// and always equal to what building it anew would give, whatever the history.
class CellIndex {
 public:
  /// Sorts all points into cells. Returns the first point outside the grid, or -1.
  int build(const BackgroundGrid& grid, const std::array<Field, 3>& position);
  /// Moves the departed points of all bricks to their new cells, where they are listed as arrivals.
  /// Returns the lowest-numbered
  /// brick's first point outside the grid, or -1.
  int move_departed(const BackgroundGrid& grid, const std::array<Field, 3>& position);

  int brick_count() const { return static_cast<int>(bricks_.size()); }  ///< as many as the grid has
  /// @{
  /// The points in brick b.
  BrickPoints& brick(int b) { return bricks_[b]; }
  const BrickPoints& brick(int b) const { return bricks_[b]; }
  /// @}
  /// Points in the order of bricks, cells and present storage: the order to store them in.
  std::vector<int> walking_order() const;
  /// After the storage took the walking order.
  void renumber_as_walked();

 private:
  std::vector<BrickPoints> bricks_;
};

}  // namespace zona::mpm
