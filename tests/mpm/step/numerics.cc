#include <catch2/catch.hpp>
#include <random>

#include "mpm/points/errors.h"
#include "mpm/results/diagnostics.h"
#include "tests/mpm/step/bar_model.h"

using namespace zona::mpm;
using Eigen::Vector3d;
using F = FaceCondition;

namespace {

/// A soft cube in free space whose points fly in all directions, about one mean velocity.
Model jittery_cube(double pic) {
  BackgroundGrid grid(Vector3d::Zero(), Vector3d::Constant(0.1), {8, 8, 8});
  const auto lattice = fill_cells(grid, {2, 2, 2}, [](const Vector3d& x) {
    return (x - Vector3d::Constant(0.4)).cwiseAbs().maxCoeff() < 0.2;
  });
  std::vector<double> mass;
  for (double v : lattice.volumes) mass.push_back(1000 * v);
  auto points = make_points(lattice.places, mass, {0.1, 0.2, -0.1});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> jitter(-0.1, 0.1);
  for (auto& component : points.velocity) {
    for (double& v : component) v += jitter(random);
  }
  LinearElastic solid({1000, 1e4, 0.3}, points.size());
  Model model{grid, {}, {}, Vector3d::Zero()};
  model.numerics.pic = pic;
  model.bodies.push_back({"cube", std::move(points), std::move(solid), {}});
  return model;
}

BodyTotals after(double pic, int steps) {
  Solver solver(jittery_cube(pic), 0.005, 2);
  for (int s = 0; s < steps; ++s) solver.step();
  return totals(solver.bodies()[0]);
}

/// A bar of 20 cells that hangs from its fixed end, x = 0, in gravity along x.
Solver hanging_bar(double damping, Interpolation interpolation = Interpolation::linear) {
  BarModel bar(22, 0.05, interpolation);
  Model model{bar.grid, {}, BarModel::faces(F::fixed, F::free), Vector3d(9.81, 0, 0)};
  auto points = bar.points(0, 1, {3, 2, 2}, 1000);
  LinearElastic solid({1000, 1e8, 0}, points.size());
  model.bodies.push_back({"bar", std::move(points), std::move(solid), {}});
  model.numerics.damping = damping;
  return Solver(std::move(model), 5e-5);
}

}  // namespace

TEST_CASE("A blend with PIC conserves momentum and dissipates more with more PIC") {
  const BodyTotals start = after(0, 0);
  const double scale = start.mass;
  const BodyTotals flip = after(0, 100), little = after(0.05, 100), all = after(1, 100);
  for (const auto* end : {&flip, &little, &all})
    CHECK((end->momentum - start.momentum).norm() < 1e-13 * scale);
  const double drift = 0.5 * start.momentum.squaredNorm() / start.mass;
  const auto motion = [&](const BodyTotals& t) {
    return t.kinetic_energy + t.stored_energy - drift;
  };
  INFO("left of the motion: FLIP " << motion(flip) / motion(start) << ", 5 % PIC "
                                   << motion(little) / motion(start) << ", PIC "
                                   << motion(all) / motion(start));
  // FLIP keeps motion that the grid does not see; a PIC step keeps what the grid sees, minus the
  // smoothing of one more mapping.
  CHECK(motion(flip) > 0.99 * motion(start));
  CHECK(motion(little) < 0.05 * motion(start));
  CHECK(motion(all) < 1e-3 * motion(start));
}

TEST_CASE("A vanishing share of PIC changes no bit") {
  Solver flip(jittery_cube(0), 0.005), blend(jittery_cube(1e-30), 0.005);
  for (int s = 0; s < 50; ++s) {
    flip.step();
    blend.step();
  }
  CHECK(flip.bodies()[0].points.velocity == blend.bodies()[0].points.velocity);
  CHECK(flip.bodies()[0].points.position == blend.bodies()[0].points.position);
}

TEST_CASE("A damped bar comes to rest at the exact static stress") {
  const auto shape = GENERATE(Interpolation::linear, Interpolation::quadratic);
  Solver solver = hanging_bar(0.7, shape);
  const double weight = 1000 * 9.81, swing = 4 / std::sqrt(1e8 / 1000);
  while (solver.time() < 20 * swing) solver.step();
  const auto& body = solver.bodies()[0];
  const auto& stress = std::get<LinearElastic>(body.material).stress[0];
  double largest = 0;
  for (int p = 0; p < body.points.size(); ++p) {
    const double x = body.points.position[0][p];
    // Linear: stress is the same all over a cell, the weight of half of it and of all below.
    const double at = shape == Interpolation::linear ? 0.05 * (std::floor(x / 0.05) + 0.5) : x;
    largest = std::max(largest, std::abs(stress[p] - weight * (1 - at)) / weight);
    CHECK(std::abs(body.points.velocity[0][p]) < 1e-6);
  }
  INFO(largest);
  // Strains of 1e-4 move points against the cells. Quadratic: the sum over three points of a cell
  // is not the integral.
  CHECK(largest < (shape == Interpolation::linear ? 2e-4 : 3e-3));
}

TEST_CASE("Damping does not change reactions") {
  BarModel bar(22, 0.05);
  Model model{bar.grid, {}, BarModel::faces(F::free, F::free), Vector3d(9.81, 0, 0)};
  auto points = bar.points(0, 1, {3, 2, 2}, 1000);
  const double weight = 1000 * 0.05 * 0.05 * 9.81;
  LinearElastic solid({1000, 1e8, 0}, points.size());
  model.bodies.push_back({"bar", std::move(points), std::move(solid), {}});
  model.held.push_back({{{0, 0, 0}, {0, 0.05, 0.05}}, {true, true, true}, {}});
  model.numerics.damping = 0.7;
  Solver solver(std::move(model), 5e-5);
  // After 28 oscillations 1e-8 of the weight is left (1e-6 after 20).
  while (solver.time() < 0.35) solver.step();
  CHECK(solver.held()[0].reaction.x() == Approx(-weight).epsilon(1e-6));
}

TEST_CASE("Invalid fractions are refused") {
  CHECK_THROWS_WITH(after(1.1, 0), Catch::Contains("PIC") && Catch::Contains("1.1"));
  CHECK_THROWS_AS(after(-0.1, 0), ModelError);
  CHECK_THROWS_WITH(hanging_bar(1), Catch::Contains("damping"));
  CHECK_THROWS_AS(hanging_bar(NAN), ModelError);
}
