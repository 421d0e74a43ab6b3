#include "mpm/cell_index.h"

#include <catch2/catch.hpp>
#include <random>

#include "mpm/errors.h"

using namespace zona::mpm;

namespace {

BackgroundGrid grid_of(int nx, int ny, int nz) {
  return {Eigen::Vector3d(-1, 0, 2), Eigen::Vector3d(0.5, 0.25, 1), {nx, ny, nz}};
}

}  // namespace

TEST_CASE("Bricks of one colour share no node and cover every cell once") {
  const BackgroundGrid grid = grid_of(13, 9, 1);
  std::vector<int> cells_covered(13 * 9, 0);
  for (const auto& colour : grid.bricks_by_colour()) {
    std::vector<int> owner(grid.node_count(), -1);
    for (int b : colour) {
      const Brick& brick = grid.bricks()[b];
      for (int j = 0; j <= brick.size[1]; ++j) {
        for (int i = 0; i <= brick.size[0]; ++i) {
          const int node = grid.node_index(brick.first_cell[0] + i, brick.first_cell[1] + j, 0);
          CHECK((owner[node] == -1 || owner[node] == b));
          owner[node] = b;
          if (i < brick.size[0] && j < brick.size[1]) {
            ++cells_covered[(brick.first_cell[1] + j) * 13 + brick.first_cell[0] + i];
          }
        }
      }
    }
  }
  for (int covered : cells_covered) CHECK(covered == 1);
}

TEST_CASE("The index kept up to date equals one built anew") {
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

TEST_CASE("Places outside the grid and places that are no numbers have no cell") {
  const BackgroundGrid grid = grid_of(4, 4, 4);
  CHECK(grid.cell_at(-1, 0, 2)[0] == 0);
  CHECK(grid.cell_at(-1.0001, 0, 2)[0] == -1);
  CHECK(grid.cell_at(1, 0, 2)[0] == -1);
  CHECK(grid.cell_at(0, NAN, 2)[0] == -1);
  CHECK_THROWS_AS(grid_of(0, 1, 1), ModelError);
}
