#include "mpm/grid/batch.h"

#include <catch2/catch.hpp>
#include <random>

#include "mpm/materials/fluid.h"
#include "mpm/materials/solid.h"
#include "mpm/step/gather.h"
#include "mpm/step/update.h"

using namespace zona::mpm;

namespace {

/// Points of an elastic solid in the cells of a brick, few in each, and nodes with random motion.
struct FewPoints {
  BackgroundGrid grid{{1, 2, 3}, {0.5, 0.4, 0.3}, {4, 4, 4}};
  MaterialPoints points;
  CellIndex index;
  LinearElastic solid{{1000, 1e7, 0.3}, 0};

  explicit FewPoints(int count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Eigen::Vector3d> places;
    std::vector<double> mass;
    for (int p = 0; p < count; ++p) {
      places.push_back({1 + 2 * unit(random), 2 + 1.6 * unit(random), 3 + 1.2 * unit(random)});
      mass.push_back(1 + unit(random));
    }
    points = make_points(places, mass);
    solid = LinearElastic({1000, 1e7, 0.3}, count);
    for (auto& component : points.velocity) {
      for (double& v : component) v = unit(random);
    }
    for (auto& component : solid.stress) {
      for (double& s : component) s = unit(random);
    }
    for (auto& node : grid.state) {
      for (int f = 0; f < 8; ++f) node[f] = unit(random);
    }
    for (auto& node : grid.updated) node = HalfLanes{unit(random), unit(random), unit(random), 0};
    REQUIRE(index.build(grid, points.position) == -1);
  }
  /// Traverses all cells one by one, or in batches.
  template <class OnCell, class OnBatch>
  void walk(bool batches, OnCell on_cell, OnBatch on_batch) {
    for_each_cell_or_batch(grid, 0, index.brick(0), batches ? 1000 : 0, on_cell, on_batch);
  }
};

template <class Nodes>
double difference(const Nodes& a, const Nodes& b, int numbers) {
  double largest = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    for (int f = 0; f < numbers; ++f) largest = std::max(largest, std::abs(a[n][f] - b[n][f]));
  }
  return largest;
}

}  // namespace

// Sums of some ten terms of order one to a thousand: a few ulp.

TEST_CASE("Batches move points and map their momentum back as cells do") {
  const double pic = GENERATE(0.0, 0.3);
  FewPoints one(61), other(61);
  FewPoints* sides[2] = {&one, &other};
  for (int side = 0; side < 2; ++side) {
    FewPoints& s = *sides[side];
    BrickPoints& brick = s.index.brick(0);
    const BlendedMotion motion{pic};
    s.walk(
        side == 1,
        [&](const Cell& cell, const int* begin, const int* end, int c) {
          gather_cell<Trilinear>(s.solid, s.points, cell, begin, end, c, 0.1, motion, brick,
                                 s.grid);
        },
        [&](const Batch& batch) {
          gather_batch(s.solid, s.points, batch, 0.1, motion, brick, s.grid);
        });
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int p = 0; p < one.points.size(); ++p) {
      CHECK(one.points.position[axis][p] == Approx(other.points.position[axis][p]).epsilon(1e-14));
      CHECK(one.points.velocity[axis][p] == Approx(other.points.velocity[axis][p]).epsilon(1e-14));
    }
  }
  CHECK(difference(one.grid.updated, other.grid.updated, 4) < 1e-13);
  const auto& departures = one.index.brick(0).departures;
  REQUIRE(departures.size() == other.index.brick(0).departures.size());
  CHECK(departures.size() > 3);
  for (std::size_t d = 0; d < departures.size(); ++d) {
    CHECK(departures[d].point == other.index.brick(0).departures[d].point);
    CHECK(departures[d].cell == other.index.brick(0).departures[d].cell);
  }
}

TEST_CASE("Batches strain points and scatter them as cells do") {
  FewPoints one(61), other(61);
  std::vector<int> bad;
  const double dt = 1e-3;
  one.walk(
      false,
      [&](const Cell& cell, const int* begin, const int* end, int) {
        update_and_scatter_cell<Trilinear>(one.solid, one.points, cell, begin, end, dt, one.grid,
                                           bad);
      },
      [](const Batch&) {});
  other.walk(
      true, [](const Cell&, const int*, const int*, int) {},
      [&](const Batch& batch) {
        update_and_scatter_batch(other.solid, other.points, batch, dt, other.grid, bad);
      });
  CHECK(bad.empty());
  double largest = 0;
  for (int c = 0; c < 6; ++c) {
    for (int p = 0; p < one.points.size(); ++p) {
      CHECK(one.solid.stress[c][p] == Approx(other.solid.stress[c][p]).epsilon(1e-12));
      largest = std::max(largest, std::abs(one.solid.stress[c][p]));
    }
  }
  CHECK(largest > 1e3);
  CHECK(difference(one.grid.state, other.grid.state, 8) < 1e-13 * largest);
  CHECK(difference(one.grid.updated, other.grid.updated, 4) < 1e-12 * one.solid.shear_wave_speed());
}
