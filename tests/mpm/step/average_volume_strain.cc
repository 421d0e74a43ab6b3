#include <catch2/catch.hpp>
#include <random>

#include "mpm/grid/shape_functions.h"
#include "mpm/points/errors.h"
#include "mpm/step/update.h"
#include "tests/mpm/step/vortex_model.h"

using namespace zona::mpm;
using Eigen::Vector3d;
using F = FaceCondition;

namespace {

/// One cell with points at random places, of random stress.
struct RandomCell {
  BackgroundGrid grid{Vector3d(1, 2, 3), Vector3d(0.5, 0.4, 0.3), {1, 1, 1}};
  Cell cell = make_cell(grid, grid.bricks()[0], 0);
  MaterialPoints points;
  LinearElastic solid;
  std::vector<int> all;

  explicit RandomCell(int count) : points(places(count)), solid({1, 1e3, 0.2}, count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> value(-1, 1);
    for (int p = 0; p < count; ++p) {
      all.push_back(p);
      solid.density[p] += 0.3 * value(random);
      for (auto& component : solid.stress) component[p] = value(random);
    }
    for (auto& node : grid.updated) node = HalfLanes{value(random), value(random), value(random)};
  }
  static MaterialPoints places(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vector3d> at;
    for (int p = 0; p < count; ++p)
      at.push_back({1 + 0.5 * unit(random), 2 + 0.4 * unit(random), 3 + 0.3 * unit(random)});
    return make_points(at, std::vector<double>(count, 0.1));
  }
  double mean() const {
    const Trilinear::CellGradient gradient(grid, cell);
    return mean_divergence(solid, points, cell, gradient, all.data(), all.data() + all.size());
  }
  /// f(point, gradient at the point, volume)
  template <class Visit>
  void for_each_point(Visit visit) const {
    const Trilinear::CellGradient gradient(grid, cell);
    for (int p : all) {
      const PointGroup group(&p, 1);
      visit(p, gradient.at(cell.natural(group.load(points.position))),
            points.mass[p] / solid.density[p]);
    }
  }
};

/// A rod of 4 x 4 cells swings at up to 0.06 m/s in a closed box of water of 16 x 16 x 1 cells of 6
/// um with 27 points each. Returns at the largest speed.
Solver rod_in_box(bool average) {
  const double h = 6e-6, speed = 0.06, omega = 2 * M_PI / 100e-6;
  BackgroundGrid grid(Vector3d(-8 * h, -8 * h, 0), Vector3d::Constant(h), {16, 16, 1});
  const auto in_rod = [=](const Vector3d& x) { return x.head<2>().cwiseAbs().maxCoeff() < 2 * h; };
  const auto points = [&](auto inside, double density) {
    const auto lattice = fill_cells(grid, {3, 3, 3}, inside);
    std::vector<double> mass;
    for (double v : lattice.volumes) mass.push_back(density * v);
    return make_points(lattice.places, mass);
  };
  Model model{grid,
              {},
              {F::roller, F::roller, F::roller, F::roller, F::roller, F::roller},
              Vector3d::Zero()};
  auto water = points([&](const Vector3d& x) { return !in_rod(x); }, 1000);
  Fluid fluid({1000, {4, 6.13e8}, 0, 8.9e-4, {}}, water.size());
  model.bodies.push_back({"water", std::move(water), std::move(fluid), {}, average});
  auto rod = points(in_rod, 26441);
  Prescribed rigid(rod, 26441, [=](double t) {
    return RigidState{{speed / omega * (1 - std::cos(omega * t)), 0, 0},
                      {speed * std::sin(omega * t), 0, 0}};
  });
  model.bodies.push_back({"rod", std::move(rod), std::move(rigid), {}});
  Solver solver(std::move(model), 2.7e-9);
  while (solver.time() < 25e-6) solver.step();
  return solver;
}

}  // namespace

TEST_CASE("Averaging leaves a homogeneous rate alone and keeps deviator, spin and total volume") {
  RandomCell random(21);
  double point_by_point = 0, averaged = 0;
  random.for_each_point([&](int, const VelocityGradient& l, double volume) {
    const VelocityGradient other = with_divergence(l, random.mean());
    point_by_point += volume * divergence(l)[0];
    averaged += volume * divergence(other)[0];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (i == j)
          CHECK(l[i][i][0] - other[i][i][0] == Approx(l[0][0][0] - other[0][0][0]).margin(1e-14));
        else
          CHECK(l[i][j][0] == other[i][j][0]);
      }
    }
  });
  CHECK(averaged == Approx(point_by_point).epsilon(1e-13));

  const double a[3][3] = {{0.3, -0.2, 0.5}, {0.7, 0.1, -0.4}, {0.2, 0.6, -0.9}};
  for (int n = 0; n < 8; ++n) {
    const double x[3] = {0.5 * (n & 1), 0.4 * (n >> 1 & 1), 0.3 * (n >> 2 & 1)};
    for (int i = 0; i < 3; ++i)
      random.grid.updated[n][i] = a[i][0] * x[0] + a[i][1] * x[1] + a[i][2] * x[2];
  }
  CHECK(random.mean() == Approx(-0.5).epsilon(1e-14));
}

TEST_CASE("With averaged rates the nodal forces do the work of the stresses") {
  RandomCell random(21);
  scatter_cell<Trilinear, Volumetric::averaged>(random.solid, random.points, random.cell,
                                                random.all.data(),
                                                random.all.data() + random.all.size(), random.grid);
  double forces = 0, stresses = 0;
  for (std::size_t n = 0; n < random.grid.node_count(); ++n) {
    for (int i = 0; i < 3; ++i) forces += random.grid.state[n][4 + i] * random.grid.updated[n][i];
  }
  random.for_each_point([&](int p, const VelocityGradient& l, double volume) {
    const PointGroup group(&p, 1);
    const auto rate = strain_rate(with_divergence(l, random.mean()));
    stresses += volume * contract(group.load(random.solid.stress), rate)[0];
  });
  CHECK(forces == Approx(-stresses).epsilon(1e-12));
}

TEST_CASE("Averaging smooths the pressure of a vortex and makes it more accurate") {
  const auto after = [](bool average) {
    const VortexModel vortex{8, 3, average};
    Solver solver = vortex.solver();
    while (solver.time() < 1) solver.step();
    return std::pair(vortex.error(solver), cell_averaged_pressure(solver.bodies()[0]).scatter);
  };
  const auto [error, scatter] = after(false);
  const auto [error_averaged, scatter_averaged] = after(true);
  INFO("velocity error " << error << " -> " << error_averaged << ", scatter " << scatter << " -> "
                         << scatter_averaged);
  // Eight cells per vortex, and every point crosses some: 0.22 to 0.063 and 6.3 to 1.1 Pa. The
  // pressure of the exact flow is 0.34 Pa.
  CHECK(error_averaged < 0.07);
  CHECK(error_averaged < error / 3);
  CHECK(scatter_averaged < scatter / 5);
}

TEST_CASE("A rod moves through water in a closed box, which otherwise locks", "[long]") {
  const auto motion = [](const Solver& solver) {
    const auto& rod = solver.body("rod").points;
    const double v = rod.velocity[0][0];
    const double displaced = 1000 * 16 * std::pow(6e-6, 3);
    return totals(solver.body("water")).kinetic_energy / (0.5 * displaced * v * v);
  };
  // The added mass of a square rod in a box four times as wide is about twice the displaced mass;
  // sound in the box adds to the energy.
  const Solver free = rod_in_box(true), locked = rod_in_box(false);
  INFO(motion(free) << " with averaging, " << motion(locked) << " without");
  CHECK(motion(free) > 1);
  CHECK(motion(free) < 4);
  CHECK(motion(locked) > 100);
  CHECK(cell_averaged_pressure(free.body("water")).scatter <
        1e-4 * cell_averaged_pressure(locked.body("water")).scatter);
}

TEST_CASE("Bodies without a volumetric strain cannot average it") {
  auto points = make_points({{0.5, 0.5, 0.5}}, {1});
  Prescribed rigid(points, 1000);
  Model model{BackgroundGrid(Vector3d::Zero(), Vector3d::Ones(), {1, 1, 1}), {}, {}, {0, 0, 0}};
  model.bodies.push_back({"rigid", std::move(points), std::move(rigid), {}, true});
  CHECK_THROWS_WITH(Solver(std::move(model), 1), Catch::Contains("'rigid'"));
}

TEST_CASE("the shear rate of a vortex is that of its velocity") {
  const VortexModel vortex{16, 3, true};
  Solver solver = vortex.solver();
  while (solver.time() < 0.1) solver.step();
  // 2 k exp(-2 nu k^2 t) in the corners; cells are 1/16 of the half wave, whose cosines are on
  // average 1 - (k h)^2 / 6 there, and the points' gradients are of first order in the cell.
  const double exact =
      2 * VortexModel::k * std::exp(-2 * vortex.viscosity * std::pow(VortexModel::k, 2) * 0.1);
  CHECK(cell_averaged_shear_rate(solver.bodies()[0]) == Approx(exact).epsilon(0.1));
}
