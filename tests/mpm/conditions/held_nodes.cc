#include <catch2/catch.hpp>

#include "mpm/results/diagnostics.h"
#include "tests/mpm/step/bar_model.h"

using namespace zona::mpm;
using Eigen::Vector3d;
using F = FaceCondition;

namespace {

/// Couette flow started at once between a fixed wall z = 0 and one at z = height with speed V: the
/// exact velocity along x.
double couette(double z, double t, double height, double viscosity, double speed) {
  double u = speed * z / height;
  for (int n = 1; n < 60; ++n) {
    const double k = n * M_PI / height;
    u += 2 * speed / (n * M_PI) * (n % 2 == 0 ? 1 : -1) * std::exp(-viscosity * k * k * t) *
         std::sin(k * z);
  }
  return u;
}

/// Water of kinematic viscosity 0.01 m^2/s in `cells` cells of height over 1 m, walls by held
/// nodes, only motion along x.
struct CouetteCell {
  static constexpr double height = 1, nu = 0.01, speed = 1e-4, rho = 1000;
  int cells;
  Interpolation interpolation;
  double h = height / cells;

  Model model() const {
    BackgroundGrid grid(Vector3d::Zero(), Vector3d::Constant(h), {1, 1, cells}, interpolation);
    const auto lattice = fill_cells(grid, {2, 2, 2}, [](const Vector3d&) { return true; });
    std::vector<double> mass;
    for (double v : lattice.volumes) mass.push_back(rho * v);
    auto points = make_points(lattice.places, mass);
    Fluid fluid({rho, {4, 2}, 0, rho * nu, {}}, points.size());
    Model model{grid, {}, {}, Vector3d::Zero()};
    model.bodies.push_back({"water", std::move(points), std::move(fluid), {}});
    const Box all{grid.origin(), grid.upper_corner()};
    model.held.push_back({all, {false, true, true}, {}});
    model.held.push_back({{all.low, {h, h, 0}}, {true, false, false}, {}});
    model.held.push_back({{{0, 0, height}, all.high},
                          {true, false, false},
                          [](double, const Vector3d&) { return Vector3d(speed, 0, 0); }});
    return model;
  }
  double exact(double z, double time) const { return couette(z, time, height, nu, speed); }
  /// Largest error of the points' velocity over the speed of the wall.
  double error_of_points(const Solver& solver) const {
    double largest = 0;
    const auto& points = solver.bodies()[0].points;
    for (int p = 0; p < points.size(); ++p) {
      const double error = points.velocity[0][p] - exact(points.position[2][p], solver.time());
      largest = std::max(largest, std::abs(error) / speed);
    }
    return largest;
  }
  /// The same of the nodes.
  double error_of_grid(const Solver& solver) const {
    double largest = 0;
    const BackgroundGrid& grid = solver.grid();
    for (int k = 0; k < grid.nodes_along()[2]; ++k) {
      const double at_node = exact(grid.node_position(0, 0, k).z(), solver.time());
      const double error = grid.updated[grid.node_index(0, 0, k)][0] - at_node;
      largest = std::max(largest, std::abs(error) / speed);
    }
    return largest;
  }
};

}  // namespace

TEST_CASE("Held nodes drive Couette flow from its start, at second order") {
  const auto shape = GENERATE(Interpolation::linear, Interpolation::quadratic);
  double grid_error[2], point_error[2];
  for (int fine : {0, 1}) {
    const CouetteCell couette_cell{fine ? 20 : 10, shape};
    Solver solver(couette_cell.model(), 0.02);
    while (solver.time() < 8) solver.step();
    grid_error[fine] = couette_cell.error_of_grid(solver);
    point_error[fine] = couette_cell.error_of_points(solver);
    while (solver.time() < 60) solver.step();
    // Steady to 2 exp(-nu pi^2 t / H^2) = 0.5 %: mu V / H on either wall.
    const double drag =
        CouetteCell::rho * CouetteCell::nu * CouetteCell::speed * couette_cell.h * couette_cell.h;
    CHECK(solver.held()[2].reaction.x() == Approx(drag).epsilon(0.01));
    CHECK(solver.held()[1].reaction.x() == Approx(-drag).epsilon(0.01));
  }
  INFO("nodes " << grid_error[0] << " " << grid_error[1] << ", points " << point_error[0] << " "
                << point_error[1]);
  CHECK(grid_error[1] < 3e-3);
  CHECK(std::log2(grid_error[0] / grid_error[1]) > 1.8);
  // With quadratic functions the points in the cells at a wall err at first order: the mass of the
  // function beside the outermost one has its centre half-way to the next, not at the middle of
  // the cell for which its value stands.
  const bool linear = shape == Interpolation::linear;
  CHECK(point_error[1] < (linear ? 2e-3 : 0.04));
  CHECK(std::log2(point_error[0] / point_error[1]) > (linear ? 1.8 : 0.95));
}

TEST_CASE("A held edge supplies the missing momentum") {
  BarModel bar(12, 0.1, GENERATE(Interpolation::linear, Interpolation::quadratic));
  Model model{bar.grid, {}, {}, Vector3d(0, 0, -9.81)};
  auto points = bar.points(0, 1, {2, 2, 2}, 1000);
  LinearElastic solid({1000, 1e6, 0.3}, points.size());
  double mass = 0;
  for (double m : points.mass) mass += m;
  model.bodies.push_back({"bar", std::move(points), std::move(solid), {}});
  const Vector3d end_force(3, 0, 0);
  model.forces.push_back({"bar", {{0.9, 0, 0}, {1, 0.1, 0.1}}, [&](double) { return end_force; }});
  model.held.push_back({{{0, 0, 0}, {0, 0.1, 0.1}}, {true, true, true}, {}});
  model.held.push_back({{{0, 0, 0}, {1.2, 0.1, 0.1}},
                        {false, true, true},
                        [](double t, const Vector3d&) { return Vector3d(0, 0, 0.01 * t); }});
  Solver solver(std::move(model), 5e-4);
  Vector3d impulse = Vector3d::Zero();
  double weighed = 0;
  for (int s = 0; s < 300; ++s) {
    solver.step();
    for (const auto& held : solver.held()) impulse += held.reaction * solver.step_size();
    weighed += solver.step_size();
  }
  const Vector3d momentum = totals(solver.bodies()[0]).momentum;
  const Vector3d given = weighed * (end_force + mass * Vector3d(0, 0, -9.81)) + impulse;
  // Rounding of 300 steps of impulses of 10 kg * 9.81 m/s^2 * 5e-4 s.
  CHECK((momentum - given).norm() < 1e-12 * mass * 9.81 * weighed);
  // Held components have the prescribed velocity at the end of the step.
  CHECK(momentum.z() == Approx(mass * 0.01 * solver.time()).epsilon(1e-9));
}
