#pragma once

#include <array>
#include <vector>

#include "mpm/grid/background_grid.h"

namespace zona::mpm {

/// A point that has moved out of the cell that lists it.
struct Departure {
  int point;  ///< storage index
  int cell;   ///< number, in the brick, of the cell that lists the point
};

/// The points of one body in one brick, cell by cell; within a cell in ascending order.
struct BrickPoints {
  std::vector<int> points;                         ///< storage indices
  std::array<int, Brick::cell_count + 1> begin{};  ///< start of each cell's points in `points`
  std::vector<Departure> departures;               ///< filled while points move
  std::vector<int> arrivals;                       ///< of the last `move_departed`, ascending

  bool empty() const { return points.empty(); }  ///< true if the brick has no points of the body
  /// @{
  /// Inserts a point into a cell of the brick, or removes it.
  void insert(int cell, int point);
  void erase(int cell, int point);
  /// @}
};

/// The points of a body, listed by cell. Points that cross cells are moved one by one; the result
/// always equals a new `build`.
class CellIndex {
 public:
  /// Sorts all points into cells. Returns the first point outside the grid, or -1.
  int build(const BackgroundGrid& grid, const std::array<Field, 3>& position);
  /// Moves the departed points of all bricks to their new cells and lists them as arrivals there.
  /// Returns the first point outside the grid, in the order of bricks, or -1.
  int move_departed(const BackgroundGrid& grid, const std::array<Field, 3>& position);

  int brick_count() const { return static_cast<int>(bricks_.size()); }  ///< of the grid
  /// @{
  /// The points in brick b.
  BrickPoints& brick(int b) { return bricks_[b]; }
  const BrickPoints& brick(int b) const { return bricks_[b]; }
  /// @}
  /// Storage indices in the order of bricks, cells and current storage.
  std::vector<int> traversal_order() const;
  /// Renumbers the points after their storage was sorted by `traversal_order`.
  void renumber_in_traversal_order();

 private:
  std::vector<BrickPoints> bricks_;
};

}  // namespace zona::mpm
