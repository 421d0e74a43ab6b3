#include "mpm/pressure/implicit_pressure.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "mpm/points/errors.h"
#include "mpm/results/diagnostics.h"
#include "tests/mpm/step/bar_model.h"

using namespace zona::mpm;
using Eigen::Vector3d;

namespace {

const FluidProperties water{1000, {4, 6.13e8}, 0, 0, {}, EnergyIncrement::mean_pressure};

/// Standing wave in a closed tube of 1 m: v = amplitude sin(pi x) at the start.
Solver standing_wave(int n, double step, double tolerance = 1e-8) {
  const BarModel bar(n, 1.0 / n);
  MaterialPoints points = bar.points(0, 1, {2, 2, 2}, 1000);
  for (int p = 0; p < points.size(); ++p)
    points.velocity[0][p] = 1e-4 * std::sin(M_PI * points.position[0][p]);
  Model model{bar.grid, {}, BarModel::faces(FaceCondition::roller, FaceCondition::roller)};
  const int count = points.size();
  model.bodies.push_back({"water", std::move(points), Fluid(water, count), {}});
  model.numerics.implicit_pressure = true;
  model.numerics.pressure_tolerance = tolerance;
  return {std::move(model), step, 1};
}

double speed_of_sound() {
  return water.state.sound_speed(0, 1000);
}

/// Amplitude of the wave's velocity over that at the start.
double amplitude(const Solver& solver) {
  const MaterialPoints& points = solver.bodies()[0].points;
  double sum = 0;
  for (int p = 0; p < points.size(); ++p)
    sum += points.velocity[0][p] * std::sin(M_PI * points.position[0][p]);
  return 2 * sum / points.size() / 1e-4;
}

Model tank(int n, double depth) {
  const double cell = 1.0 / n;
  BackgroundGrid grid(Vector3d::Zero(), Vector3d::Constant(cell), {n, 2, n + n / 2});
  const auto lattice =
      fill_cells(grid, {2, 2, 2}, [depth](const Vector3d& x) { return x.z() < depth; });
  std::vector<double> mass;
  for (const double v : lattice.volumes) mass.push_back(1000 * v);
  auto points = make_points(lattice.places, mass);
  const int count = points.size();
  using F = FaceCondition;
  Model model{grid, {}, {F::roller, F::roller, F::roller, F::roller, F::roller, F::free}};
  model.bodies.push_back({"water", std::move(points), Fluid(water, count), {}});
  model.numerics.implicit_pressure = true;
  model.gravity = Vector3d(0, 0, -9.81);
  return model;
}

}  // namespace

TEST_CASE("Small steps carry a standing wave at second order") {
  double last = 0;
  for (const int n : {8, 16, 32}) {
    // A quarter of a cell per step: the explicit step, with next to no damping.
    const double period = 2 / speed_of_sound();
    const double longest = 0.25 / n / speed_of_sound();
    const long steps = std::lround(period / longest);
    Solver solver = standing_wave(n, period / steps);
    for (long s = 0; s < steps; ++s) solver.step();
    const double error = std::abs(amplitude(solver) - 1);
    if (last > 0) CHECK(last / error > 3);
    last = error;
  }
  CHECK(last < 2e-2);
}

TEST_CASE("Large steps damp sound as backward Euler does") {
  const double step = 8.0 / 16 / speed_of_sound();  // eight cells
  Solver solver = standing_wave(16, step);
  const double theta = 1 - 0.25 / 64;
  // The grid's frequency of the lowest wave.
  const double s = 2 * 16 * std::sin(M_PI / 32) * speed_of_sound() * step;
  const double damping = 1 / std::sqrt(1 + theta * s * s);
  // v' = (v - s p) / (1 + theta s^2), p' = p + s v'
  double v = 1;
  double p = 0;
  for (int n = 0; n < 6; ++n) {
    solver.step();
    v = (v - s * p) / (1 + theta * s * s);
    p += s * v;
    // Nodes see sin(pi x) of the points reduced, and points that of the nodes: (pi h)^2 / 6 or
    // less.
    CHECK(amplitude(solver) == Approx(v).margin(0.01));
  }
  CHECK(std::hypot(v, p) < 1.5 * std::pow(damping, 6));
}

TEST_CASE("Water at rest under gravity stays at rest") {
  const int n = 8;
  Model model = tank(n, 0.5);
  model.numerics.pressure_tolerance = 1e-9;
  const double step = 1e-3;
  Solver solver(std::move(model), step, 2);
  for (int s = 0; s < 200; ++s) solver.step();
  const Body& body = solver.bodies()[0];
  const auto& fluid = std::get<Fluid>(body.material);
  // Free fall would have reached 2 m/s. The surface settles by rho g d^2 / 2 K = 4e-7 m once.
  for (int p = 0; p < body.points.size(); ++p) {
    CHECK(body.points.velocity_of(p).norm() < 1e-5);
    const int layer = static_cast<int>(body.points.position[2][p] * n);
    const double depth = 0.5 - (layer + 0.5) / n;
    CHECK(-fluid.stress[0][p] == Approx(1000 * 9.81 * depth).epsilon(2e-3));
  }
}

TEST_CASE("A closed box keeps mass and, without walls, momentum") {
  Model model = tank(6, 0.6);
  model.faces.fill(FaceCondition::free);
  model.gravity.setZero();
  // Tumbling water in the middle of the grid.
  MaterialPoints& points = model.bodies[0].points;
  for (int p = 0; p < points.size(); ++p) {
    points.position[2][p] += 0.4;
    points.velocity[0][p] = 0.2 * std::sin(7 * points.position[2][p]);
    points.velocity[2][p] = 0.1 * std::cos(5 * points.position[0][p]);
  }
  const BodyTotals before = totals(model.bodies[0]);
  Solver solver(std::move(model), 1e-3, 2);
  for (int s = 0; s < 50; ++s) solver.step();
  const BodyTotals after = totals(solver.bodies()[0]);
  CHECK(after.mass == before.mass);
  // Forces have no resultant; the rest is round-off of some 1e4 sums.
  CHECK((after.momentum - before.momentum).norm() < 1e-11 * before.momentum.norm());
}

TEST_CASE("Implicit pressure gives the same bits for any number of threads") {
  const auto run = [](int threads) {
    Solver solver(tank(8, 0.7), 2e-3, threads);
    for (int s = 0; s < 20; ++s) solver.step();
    return solver.bodies()[0].points.velocity[2];
  };
  const Field one = run(1);
  for (const int threads : {2, 3}) {
    const Field many = run(threads);
    CHECK(std::memcmp(one.data(), many.data(), one.size() * sizeof(double)) == 0);
  }
}

TEST_CASE("Implicit pressure refuses what it cannot do") {
  Model quadratic = tank(4, 0.5);
  quadratic.grid = BackgroundGrid(Vector3d::Zero(), Vector3d::Constant(0.25), {4, 2, 6},
                                  Interpolation::quadratic);
  CHECK_THROWS_WITH(Solver(std::move(quadratic), 1e-3), Catch::Contains("linear shape functions"));
  Model loose = tank(4, 0.5);
  loose.numerics.pressure_tolerance = 0.5;
  CHECK_THROWS_WITH(Solver(std::move(loose), 1e-3), Catch::Contains("tolerance of the pressure"));
  Model damped = tank(4, 0.5);
  damped.numerics.damping = 0.2;
  CHECK_THROWS_WITH(Solver(std::move(damped), 1e-3), Catch::Contains("damping"));
}
