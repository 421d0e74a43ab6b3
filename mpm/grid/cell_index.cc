#include "mpm/grid/cell_index.h"

#include <algorithm>
#include <numeric>

namespace zona::mpm {

void BrickPoints::insert(int cell, int point) {
  const auto first = points.begin() + begin[cell];
  const auto last = points.begin() + begin[cell + 1];
  points.insert(std::lower_bound(first, last, point), point);
  for (int c = cell + 1; c <= Brick::cell_count; ++c) ++begin[c];
}

void BrickPoints::erase(int cell, int point) {
  const auto first = points.begin() + begin[cell];
  const auto last = points.begin() + begin[cell + 1];
  points.erase(std::lower_bound(first, last, point));
  for (int c = cell + 1; c <= Brick::cell_count; ++c) --begin[c];
}

int CellIndex::build(const BackgroundGrid& grid, const std::array<Field, 3>& position) {
  const int count = static_cast<int>(position[0].size());
  bricks_.assign(grid.bricks().size(), {});
  std::vector<int> brick_of(count), cell_of(count);
  for (int p = 0; p < count; ++p) {
    const auto cell = grid.cell_at(position[0][p], position[1][p], position[2][p]);
    if (cell[0] < 0) return p;
    brick_of[p] = grid.brick_of(cell);
    cell_of[p] = BackgroundGrid::cell_in_brick(cell);
    ++bricks_[brick_of[p]].begin[cell_of[p] + 1];
  }
  for (auto& brick : bricks_) {
    std::partial_sum(brick.begin.begin(), brick.begin.end(), brick.begin.begin());
    brick.points.resize(brick.begin.back());
  }
  std::vector<std::array<int, Brick::cell_count>> next(bricks_.size());
  for (std::size_t b = 0; b < bricks_.size(); ++b) {
    std::copy_n(bricks_[b].begin.begin(), Brick::cell_count, next[b].begin());
  }
  for (int p = 0; p < count; ++p) bricks_[brick_of[p]].points[next[brick_of[p]][cell_of[p]]++] = p;
  return -1;
}

int CellIndex::move_departed(const BackgroundGrid& grid, const std::array<Field, 3>& position) {
  for (auto& brick : bricks_) brick.arrivals.clear();
  for (auto& brick : bricks_) {
    for (const auto& [point, cell] : brick.departures) {
      const auto target = grid.cell_at(position[0][point], position[1][point], position[2][point]);
      if (target[0] < 0) return point;
      brick.erase(cell, point);
      BrickPoints& entered = bricks_[grid.brick_of(target)];
      entered.insert(BackgroundGrid::cell_in_brick(target), point);
      entered.arrivals.push_back(point);
    }
    brick.departures.clear();
  }
  for (auto& brick : bricks_) std::sort(brick.arrivals.begin(), brick.arrivals.end());
  return -1;
}

std::vector<int> CellIndex::traversal_order() const {
  std::vector<int> order;
  for (const auto& brick : bricks_) {
    order.insert(order.end(), brick.points.begin(), brick.points.end());
  }
  return order;
}

void CellIndex::renumber_in_traversal_order() {
  int next = 0;
  for (auto& brick : bricks_) {
    std::iota(brick.points.begin(), brick.points.end(), next);
    next += static_cast<int>(brick.points.size());
  }
}

}  // namespace zona::mpm
