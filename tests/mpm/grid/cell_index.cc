#include "mpm/grid/cell_index.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "mpm/grid/cell.h"
#include "mpm/points/errors.h"

using namespace zona::mpm;

namespace {

BackgroundGrid grid_of(int nx, int ny, int nz,
                       Interpolation interpolation = Interpolation::linear) {
  return {Eigen::Vector3d(-1, 0, 2), Eigen::Vector3d(0.5, 0.25, 1), {nx, ny, nz}, interpolation};
}

}  // namespace

TEST_CASE("Bricks of one colour share no node and cover every cell once") {
  const auto interpolation = GENERATE(Interpolation::linear, Interpolation::quadratic);
  const auto cells = GENERATE(std::array<int, 3>{13, 9, 1}, std::array<int, 3>{9, 5, 8},
                              std::array<int, 3>{10, 1, 11});
  const BackgroundGrid grid = grid_of(cells[0], cells[1], cells[2], interpolation);
  std::vector<int> covered(cells[0] * cells[1] * cells[2], 0);
  bool shared = false;
  for (const auto& colour : grid.bricks_by_colour()) {
    std::vector<int> owner(grid.node_count(), -1);
    for (int b : colour) {
      const Brick& brick = grid.bricks()[b];
      for (int c = 0; c < Brick::cell_count; ++c) {
        const Cell cell = make_cell(grid, brick, c);
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis)
          inside &= cell.index[axis] < brick.first_cell[axis] + brick.size[axis];
        if (!inside) continue;
        ++covered[(cell.index[2] * cells[1] + cell.index[1]) * cells[0] + cell.index[0]];
        for (int n = 0; n < grid.nodes_per_cell(); ++n) {
          int& owned = owner.at(cell.first_node + grid.node_offsets()[n]);
          shared |= owned != -1 && owned != b;
          owned = b;
        }
      }
    }
  }
  CHECK_FALSE(shared);
  CHECK(std::all_of(covered.begin(), covered.end(), [](int times) { return times == 1; }));
}

TEST_CASE("An updated index equals one built anew") {
  const BackgroundGrid grid = grid_of(9, 10, 11);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const Eigen::Vector3d size = grid.upper_corner() - grid.origin();
  std::array<Field, 3> x;
  for (int axis = 0; axis < 3; ++axis) {
    for (int p = 0; p < 2000; ++p)
      x[axis].push_back(grid.origin()[axis] + size[axis] * unit(random));
  }
  CellIndex index;
  REQUIRE(index.build(grid, x) == -1);
  for (int round = 0; round < 20; ++round) {
    for (std::size_t b = 0; b < grid.bricks().size(); ++b) {
      auto& brick = index.brick(static_cast<int>(b));
      for (int c = 0; c < Brick::cell_count; ++c) {
        for (int n = brick.begin[c]; n < brick.begin[c + 1]; ++n) {
          const int p = brick.points[n];
          if (unit(random) > 0.1) continue;
          for (int axis = 0; axis < 3; ++axis)
            x[axis][p] = grid.origin()[axis] + size[axis] * unit(random);
          brick.departures.push_back({p, c});
        }
      }
    }
    REQUIRE(index.move_departed(grid, x) == -1);
    CellIndex anew;
    REQUIRE(anew.build(grid, x) == -1);
    for (std::size_t b = 0; b < grid.bricks().size(); ++b) {
      REQUIRE(index.brick(static_cast<int>(b)).points == anew.brick(static_cast<int>(b)).points);
      REQUIRE(index.brick(static_cast<int>(b)).begin == anew.brick(static_cast<int>(b)).begin);
    }
  }
}

TEST_CASE("Places outside the grid and places with NaN have no cell") {
  const BackgroundGrid grid = grid_of(4, 4, 4);
  CHECK(grid.cell_at(-1, 0, 2)[0] == 0);
  CHECK(grid.cell_at(-1.0001, 0, 2)[0] == -1);
  CHECK(grid.cell_at(1, 0, 2)[0] == -1);
  CHECK(grid.cell_at(0, NAN, 2)[0] == -1);
  CHECK_THROWS_AS(grid_of(0, 1, 1), ModelError);
}
