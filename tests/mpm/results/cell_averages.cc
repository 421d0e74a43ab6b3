#include "mpm/results/cell_averages.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mpm/bodies/lattice.h"
#include "mpm/points/errors.h"
#include "mpm/step/solver.h"
#include "tests/scratch_directory.h"

using namespace zona::mpm;
using Eigen::Vector3d;

namespace {

BackgroundGrid make_grid() {
  return {{1, 2, 3}, {0.1, 0.2, 0.05}, {5, 6, 7}};
}

/// Eight points in each cell whose middle is left of x = 1.3 m, each moving as the place it is at.
Model water() {
  Model model{make_grid(), {}, {}, Vector3d::Zero()};
  const auto places =
      fill_cells(model.grid, {2, 2, 2}, [](const Vector3d& x) { return x.x() < 1.3; });
  std::vector<double> mass;
  for (const double volume : places.volumes) mass.push_back(1000 * volume);
  auto points = make_points(places.places, mass);
  for (int p = 0; p < points.size(); ++p)
    for (int axis = 0; axis < 3; ++axis) points.velocity[axis][p] = points.position[axis][p];
  model.bodies.push_back({"water", points, Fluid({1000, {4, 1e6}, 0, 0, {}}, points.size()), {}});
  return model;
}

}  // namespace

TEST_CASE("cell averages of a linear field are its values at the centres", "[frames]") {
  const Solver solver(water(), 1e-6, 1);
  const CellFields cells = cell_averages(solver.body("water"), solver.grid(), "cells");
  CHECK(cells.boundaries[1].size() == 7);
  CHECK(cells.boundaries[1][6] == Approx(3.2));
  REQUIRE(cells.fields.at("velocity").size() == 3 * 5 * 6 * 7);
  std::size_t cell = 0;
  for (int k = 0; k < 7; ++k) {
    for (int j = 0; j < 6; ++j) {
      for (int i = 0; i < 5; ++i, ++cell) {
        const double points = cells.fields.at("points")[cell];
        REQUIRE(points == (i < 3 ? 8 : 0));
        const double* v = &cells.fields.at("velocity")[3 * cell];
        if (points == 0) {
          REQUIRE(std::isnan(v[0]));
          continue;
        }
        REQUIRE(v[0] == Approx(1.05 + 0.1 * i));
        REQUIRE(v[1] == Approx(2.1 + 0.2 * j));
        REQUIRE(v[2] == Approx(3.025 + 0.05 * k));
        REQUIRE(cells.fields.at("density")[cell] == Approx(1000));
      }
    }
  }
}

TEST_CASE("cells are written beside clouds, invalid ones refused", "[frames]") {
  const zona::tests::ScratchDirectory scratch;
  FrameWriter writer(scratch.path());
  const CellFields good{"cells", {{{0, 1, 2}, {0, 1}, {0, 1, 2, 3}}}, {{"a", {1, 2, 3, 4, 5, 6}}}};
  writer.add_frame(0, {}, {good});
  const Hdf5File file = Hdf5File::open(scratch / "fields.h5");
  CHECK(file.shape("/cells/000000/cells/fields/a") == std::vector<std::size_t>{3, 1, 2});
  CHECK(file.read<double>("/cells/000000/cells/z") == std::vector<double>{0, 1, 2, 3});

  CellFields few = good, flat = good, folded = good;
  few.fields["a"].pop_back();
  flat.boundaries[1] = {0};
  folded.boundaries[2] = {0, 2, 1, 3};
  for (const CellFields& bad : {few, flat, folded})
    CHECK_THROWS_AS(writer.add_frame(1, {}, {bad}), std::invalid_argument);
  CHECK_THROWS_AS(writer.add_frame(1, {}, {good, good}), std::invalid_argument);
  CHECK(writer.frame_count() == 1);
}
