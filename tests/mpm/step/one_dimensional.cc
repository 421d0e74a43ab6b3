#include <catch2/catch.hpp>
#include <numeric>

#include "mpm/points/errors.h"
#include "tests/mpm/step/bar_model.h"
#include "tests/mpm/step/riemann.h"

using namespace zona::mpm;
using F = FaceCondition;

namespace {

struct TubeErrors {
  double density, velocity, pressure;
};

/// The shock tube of 4.4.1 with `cells` cells of 5 x 5 x 1 points, L1 errors of cell averages.
TubeErrors shock_tube(int cells, Interpolation interpolation = Interpolation::linear) {
  const ShockTube exact{1.4, 1, 1, 0.125, 0.001};
  const double h = 1.0 / cells, end = 0.143;
  BarModel bar(cells, h, interpolation);
  Model model{bar.grid, {}, BarModel::faces(F::roller, F::roller), Eigen::Vector3d::Zero()};
  const auto gas = [&](const char* name, double low, double high, double rho, double p) {
    auto points = bar.points(low, high, {5, 5, 1}, rho);
    Fluid fluid({rho, StiffenedGas::ideal_gas(1.4), p, 0, {2, 1}}, points.size());
    model.bodies.push_back({name, std::move(points), std::move(fluid), {}});
  };
  gas("left", 0, 0.5, 1, 1);
  gas("right", 0.5, 1, 0.125, 0.001);
  Solver solver(std::move(model), 2e-5 * 800 / cells);
  while (solver.time() < end - 1e-9) solver.step();

  std::vector<double> mass(cells), density(cells), momentum(cells), pressure(cells);
  for (const auto& body : solver.bodies()) {
    const auto& fluid = std::get<Fluid>(body.material);
    for (int p = 0; p < body.points.size(); ++p) {
      const int cell = static_cast<int>(body.points.position[0][p] / h);
      const double m = body.points.mass[p];
      mass[cell] += m;
      density[cell] += m * fluid.density[p];
      momentum[cell] += m * body.points.velocity[0][p];
      pressure[cell] -= m * fluid.stress[0][p];
    }
  }
  TubeErrors errors{};
  for (int c = 0; c < cells; ++c) {
    if (mass[c] == 0) continue;
    const auto e = exact.at(((c + 0.5) * h - 0.5) / solver.time());
    errors.density += h * std::abs(density[c] / mass[c] - e.density);
    errors.velocity += h * std::abs(momentum[c] / mass[c] - e.velocity);
    errors.pressure += h * std::abs(pressure[c] / mass[c] - e.pressure);
  }
  return errors;
}

}  // namespace

TEST_CASE("The exact shock tube is the one of 4.4.1") {
  const ShockTube exact{1.4, 1, 1, 0.125, 0.001};
  CHECK(exact.star_pressure() == Approx(0.21086).epsilon(1e-4));
  CHECK(exact.shock_speed() == Approx(1.42332).epsilon(1e-5));
  CHECK(exact.at(1.3).density == Approx(0.72983).epsilon(1e-4));
  CHECK(exact.at(1.3).velocity == Approx(1.17954).epsilon(1e-5));
}

TEST_CASE("Shock tube of 4.4.1 converges to the exact solution", "[long]") {
  // A captured shock converges at first order in L1. Beyond 200 cells linear functions stop
  // improving density and pressure: in the expansion, where points cross cells of other density.
  const TubeErrors coarse = shock_tube(100), fine = shock_tube(200), finest = shock_tube(400);
  INFO("L1 errors at 100 cells: " << coarse.density << " " << coarse.velocity << " "
                                  << coarse.pressure);
  INFO("L1 errors at 200 cells: " << fine.density << " " << fine.velocity << " " << fine.pressure);
  CHECK(std::log2(coarse.density / fine.density) > 0.9);
  CHECK(std::log2(coarse.velocity / fine.velocity) > 0.9);
  CHECK(std::log2(coarse.pressure / fine.pressure) > 0.9);
  CHECK(finest.density < fine.density);
  CHECK(finest.velocity < fine.velocity);
  CHECK(finest.pressure < fine.pressure);
}

TEST_CASE("The shock tube converges further with quadratic functions", "[long]") {
  const TubeErrors coarse = shock_tube(100, Interpolation::quadratic);
  const TubeErrors fine = shock_tube(400, Interpolation::quadratic);
  const TubeErrors linear = shock_tube(400);
  INFO("L1 errors at 400 cells: " << fine.density << " " << fine.velocity << " " << fine.pressure);
  // Observed orders over two refinements 0.90, 0.96, 0.93; linear 0.71, 0.85, 0.66.
  CHECK(std::log2(coarse.density / fine.density) / 2 > 0.85);
  CHECK(std::log2(coarse.velocity / fine.velocity) / 2 > 0.9);
  CHECK(std::log2(coarse.pressure / fine.pressure) / 2 > 0.9);
  CHECK(fine.density < 0.85 * linear.density);
  CHECK(fine.velocity < linear.velocity);
  CHECK(fine.pressure < 0.8 * linear.pressure);
}

namespace {

struct WaterColumn {
  static constexpr double h = 0.01;
  FluidProperties water{1000, {4, 6.13e8}, 0, 8.9e-4, {}};
  double c = water.state.sound_speed(0, 1000);
};

/// Mean stress [Pa] at 0.6 m from the arrival of the front until 0.5 ms: the piston of Figure 5.13.
double mean_impact_stress(F right, int cells) {
  const WaterColumn column;
  const ElasticProperties piston{2000, 2e7, 0.2};
  BarModel bar(cells, column.h);
  Model model{bar.grid, {}, BarModel::faces(F::free, right), Eigen::Vector3d::Zero()};
  auto solid_points = bar.points(0, 0.5, {5, 5, 1}, 2000, 10);
  LinearElastic solid(piston, solid_points.size());
  model.bodies.push_back({"piston", std::move(solid_points), std::move(solid), {}});
  auto fluid_points = bar.points(0.5, 2, {5, 5, 1}, 1000);
  Fluid fluid(column.water, fluid_points.size());
  model.bodies.push_back({"water", std::move(fluid_points), std::move(fluid), {}});
  Solver solver(std::move(model), 1e-7);
  double sum = 0, count = 0;
  while (solver.time() < 5e-4) {
    solver.step();
    if (solver.time() < 0.1 / column.c) continue;
    const auto& body = solver.body("water");
    const auto& f = std::get<Fluid>(body.material);
    for (int p = 0; p < body.points.size(); ++p) {
      if (std::abs(body.points.position[0][p] - 0.6) > column.h) continue;
      sum += f.stress[0][p];
      ++count;
    }
  }
  return sum / count;
}

/// Reflection of a smooth sound pulse at the right end, relative to the incident pulse.
double reflected_fraction(F right, int empty_cells, Interpolation interpolation) {
  const WaterColumn column;
  const double length = 1, amplitude = 0.01;
  BarModel bar(100 + empty_cells, column.h, interpolation);
  Model model{bar.grid, {}, BarModel::faces(F::roller, right), Eigen::Vector3d::Zero()};
  auto points = bar.points(0, length, {3, 1, 1}, 1000);
  Fluid fluid(column.water, points.size());
  for (int p = 0; p < points.size(); ++p) {
    const double s = (points.position[0][p] - 0.5) / 0.08;
    const double v = amplitude * std::exp(-s * s);
    const double pressure = 1000 * column.c * v;
    points.velocity[0][p] = v;
    fluid.density[p] = 1000 * (1 + v / column.c);
    fluid.internal_energy[p] = column.water.state.internal_energy(pressure, fluid.density[p]);
    for (int i = 0; i < 3; ++i) fluid.stress[i][p] = -pressure;
  }
  model.bodies.push_back({"water", std::move(points), std::move(fluid), {}});
  Solver solver(std::move(model), 0.3 * column.h / column.c);
  while (solver.time() < 1.0 / column.c) solver.step();  // to the end and back
  double largest = 0;
  const auto& body = solver.bodies()[0];
  for (double v : body.points.velocity[0]) largest = std::max(largest, std::abs(v));
  return largest / amplitude;
}

}  // namespace

TEST_CASE("Impact stress of Figure 5.13, whole tube and absorbing boundary", "[long]") {
  // Exact until the reflection from the far end arrives: -v Z1 Z2 / (Z1 + Z2), Z = rho c. The soft
  // piston is resolved by so few cells that the stress rings by more than its mean; what the grid
  // conserves is momentum, so the mean from the arrival on is exact up to the ringing's last,
  // incomplete period.
  const ElasticProperties piston{2000, 2e7, 0.2};
  const double z1 = 2000 * std::sqrt(piston.moduli().constrained() / 2000);
  const double z2 = 1000 * WaterColumn().c;
  const double exact = -10 * z1 * z2 / (z1 + z2);
  CHECK(mean_impact_stress(F::fixed, 100) == Approx(exact).epsilon(0.03));
  CHECK(mean_impact_stress(F::absorbing, 70) == Approx(exact).epsilon(0.03));
}

TEST_CASE("The absorbing boundary reflects less than 2 %, a free or fixed end everything") {
  const auto shape = GENERATE(Interpolation::linear, Interpolation::quadratic);
  CHECK(reflected_fraction(F::absorbing, 0, shape) < 0.02);
  CHECK(reflected_fraction(F::fixed, 0, shape) == Approx(1).epsilon(0.05));
  CHECK(reflected_fraction(F::free, 5, shape) == Approx(1).epsilon(0.05));
}

TEST_CASE("A plate that moves as prescribed into water feels rho c v per area") {
  const FluidProperties water{1000, {4, 6.13e8}, 0, 0, {}};
  const double h = 0.01, v = 1, c = water.state.sound_speed(0, 1000);
  const auto shape = GENERATE(Interpolation::linear, Interpolation::quadratic);
  for (Drive drive : {Drive::points, Drive::nodes}) {
    BarModel bar(100, h, shape);
    Model model{bar.grid, {}, BarModel::faces(F::free, F::absorbing), Eigen::Vector3d::Zero()};
    // Heavy, so that the shared nodes at its front follow it.
    auto plate_points = bar.points(0.1, 0.2, {3, 1, 1}, 1e6);
    const RigidMotion motion = [v](double t) { return RigidState{{v * t, 0, 0}, {v, 0, 0}}; };
    Prescribed plate(plate_points, 1e6, motion, drive);
    model.bodies.push_back({"plate", std::move(plate_points), std::move(plate), {}});
    auto fluid_points = bar.points(0.2, 1, {3, 1, 1}, 1000);
    Fluid fluid(water, fluid_points.size());
    model.bodies.push_back({"water", std::move(fluid_points), std::move(fluid), {}});
    Solver solver(std::move(model), 0.4 * h / c);
    double impulse = 0, begin = 1e-4, end = 7e-4;
    while (solver.time() < end) {
      solver.step();
      if (solver.time() > begin)
        impulse += solver.body("plate").prescribed()->reaction.x() * solver.step_size();
    }
    CHECK(impulse / (end - begin) == Approx(1000 * c * v * h * h).epsilon(0.02));
    CHECK(solver.body("plate").points.position[0][0] - 0.1 < 0.1 + v * end);
  }
}

TEST_CASE("Free fall is exact, also across cells and re-orderings of the storage") {
  const auto shape = GENERATE(Interpolation::linear, Interpolation::quadratic);
  BackgroundGrid grid(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(0.1), {6, 6, 12}, shape);
  const auto lattice = fill_cells(grid, {2, 2, 2}, [](const Eigen::Vector3d& x) {
    return (x - Eigen::Vector3d(0.3, 0.3, 1.0)).cwiseAbs().maxCoeff() < 0.1;
  });
  std::vector<double> mass;
  for (double v : lattice.volumes) mass.push_back(1000 * v);
  auto points = make_points(lattice.places, mass);
  LinearElastic cube({1000, 1e4, 0.3}, points.size());
  Model model{grid, {}, {}, Eigen::Vector3d(0, 0, -9.81)};
  model.bodies.push_back({"cube", points, std::move(cube), {}});
  Solver solver(std::move(model), 5e-4, 2);
  const int steps = 700;
  for (int s = 0; s < steps; ++s) solver.step();
  const double t = solver.time();
  // Symplectic Euler: the velocity is exact, the fall g t (t + dt) / 2.
  const double fall = 9.81 * t * (t + solver.step_size()) / 2;
  const auto& body = solver.body("cube");
  for (int p = 0; p < body.points.size(); ++p) {
    CHECK(body.points.velocity[2][p] == Approx(-9.81 * t).epsilon(1e-9));
    const Eigen::Vector3d start = lattice.places[body.points.id[p]];
    CHECK(start.z() - body.points.position[2][p] == Approx(fall).epsilon(1e-9));
    CHECK(body.points.position[0][p] == Approx(start.x()).epsilon(1e-9));
  }
}
