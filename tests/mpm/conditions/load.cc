#include "mpm/conditions/load.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "mpm/points/errors.h"
#include "mpm/results/diagnostics.h"
#include "tests/mpm/step/bar_model.h"

using namespace zona::mpm;
using Eigen::Vector3d;
using F = FaceCondition;

namespace {

Vector3d momentum_of(const Solver& solver) {
  Vector3d momentum = Vector3d::Zero();
  for (const auto& body : solver.bodies()) momentum += totals(body).momentum;
  return momentum;
}

/// A membrane alone in a box of 8^3 cells around [-1, 1]^3, its points of 1 kg.
Model membrane_in_box(const TriangulatedSurface& surface,
                      Interpolation interpolation = Interpolation::linear) {
  BackgroundGrid grid(Vector3d::Constant(-1.5), Vector3d::Constant(0.375), {8, 8, 8},
                      interpolation);
  auto points = make_points(surface.places, std::vector<double>(surface.places.size(), 1));
  Membrane membrane({1000, 0.01, 1e6, 0.3, OneWay::stress}, {}, false, points, surface.triangles);
  Model model{grid, {}, {}, Vector3d::Zero()};
  model.bodies.push_back({"membrane", std::move(points), std::move(membrane), {}});
  return model;
}

/// A sheet over [-1, 1]^2 with a dome on it. Its rim is flat, so a pressure p pushes with 4 p.
TriangulatedSurface dome() {
  auto surface = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 21, 21);
  for (auto& x : surface.places) x.z() = 0.5 * (1 - x.x() * x.x()) * (1 - x.y() * x.y());
  return surface;
}

Vector3d resultant(Model model) {
  const double dt = 1e-4;
  Solver solver(std::move(model), dt, 2);
  solver.step();
  return momentum_of(solver) / dt;
}

}  // namespace

TEST_CASE("A box contains its surface and, when flat, its plane") {
  const Box box{{0, 0, 0}, {1, 2, 0}};
  CHECK(box.contains({1, 2, 0}));
  CHECK(box.contains({0.3, 2 + 1e-9, -1e-9}));
  CHECK_FALSE(box.contains({0.3, 2 + 1e-8, 0}));
  CHECK_FALSE(box.contains({0.3, 1, 1e-8}));
}

TEST_CASE("A bar pulled at its end carries F/A and moves with F/(A rho c) behind the front") {
  const auto shape = GENERATE(Interpolation::linear, Interpolation::quadratic);
  const ElasticProperties steel{8000, 2e8, 0};
  const int cells = 100;
  const double h = 0.01, c = std::sqrt(2e8 / 8000), force = 2, area = h * h;
  BarModel bar(cells + 5, h, shape);
  const double length = cells * h, ramp = 40 * h / c;
  Model model{bar.grid, {}, BarModel::faces(F::roller, F::free), Vector3d::Zero()};
  auto points = bar.points(0, length, {3, 1, 1}, 8000);
  LinearElastic solid(steel, points.size());
  model.bodies.push_back({"bar", std::move(points), std::move(solid), {}});
  const auto pull = [&](double t) {
    const double s = std::clamp(t / ramp, 0.0, 1.0);
    return force * s * s * (3 - 2 * s);
  };
  model.forces.push_back({"bar", {{length - h, 0, 0}, {length, h, h}}, [&](double t) {
                            return Vector3d(pull(t), 0, 0);
                          }});
  Solver solver(std::move(model), 0.2 * h / c);
  double given = 0;
  while (solver.time() < 0.7 * length / c) {
    given += pull(solver.time()) * solver.step_size();
    solver.step();
  }
  const auto& body = solver.bodies()[0];
  const auto& stress = std::get<LinearElastic>(body.material).stress[0];
  for (int p = 0; p < body.points.size(); ++p) {
    const double x = body.points.position[0][p];
    if (x > length - 2 * h) continue;
    // Half of a wave that starts inside goes to the free end first: on average it starts there.
    const double exact = pull(solver.time() - (length - x) / c) / area;
    // The load spreads over a cell or two of the 40 of the ramp, half a step between velocity and
    // stress, 0.1 cells, and dispersion, of which quadratic functions have more.
    const double tolerance = (shape == Interpolation::linear ? 0.01 : 0.015) * force / area;
    CHECK(body.points.velocity[0][p] * 8000 * c == Approx(exact).margin(tolerance));
    // Linear: stress is the same all over a cell, so a third of one times the largest slope on top.
    CHECK(stress[p] == Approx(exact).margin(tolerance + 1.5 / 40 / 3 * force / area));
  }
  // Rounding of some thousand steps.
  CHECK(momentum_of(solver).x() == Approx(given).epsilon(1e-10));
}

TEST_CASE("A force is shared by mass and stays with its points") {
  BarModel bar(10, 1);
  Model model{bar.grid, {}, {}, Vector3d::Zero()};
  auto points = bar.points(2, 4, {2, 2, 2}, 1);
  LinearElastic solid({1, 1, 0}, points.size());
  for (int p = 0; p < 8; ++p) points.mass[p] *= 3;
  model.bodies.push_back({"block", std::move(points), std::move(solid), {}});
  model.forces.push_back(
      {"block", {{2, 0, 0}, {4, 1, 1}}, [](double) { return Vector3d(4, 0, 0); }});
  Solver solver(std::move(model), 0.01);
  while (solver.time() < 2) solver.step();
  // Every point has the same acceleration, F / m = 4 / 4: free fall along x, over cells and a
  // re-ordering of the storage.
  const double t = solver.time();
  const auto& block = solver.bodies()[0];
  for (int p = 0; p < block.points.size(); ++p) {
    CHECK(block.points.velocity[0][p] == Approx(t).epsilon(1e-9));
    CHECK(block.points.velocity[1][p] == Approx(0).margin(1e-12));
  }
}

TEST_CASE("Pressure on a closed surface has no resultant, on an open one that of its rim") {
  const auto shape = GENERATE(Interpolation::linear, Interpolation::quadratic);
  const double p = 7;
  Model sphere = membrane_in_box(icosphere(Vector3d::Zero(), 1, 4), shape);
  sphere.pressures.push_back({"membrane", [&](double) { return p; }});
  // Area vectors cancel to rounding.
  CHECK(resultant(std::move(sphere)).norm() < 1e-12 * p * 4 * M_PI);
  Model open = membrane_in_box(dome(), shape);
  open.pressures.push_back({"membrane", [&](double) { return p; }});
  const Vector3d total = resultant(std::move(open));
  CHECK(total.z() == Approx(4 * p).epsilon(1e-12));
  CHECK(total.head<2>().norm() < 1e-12 * p);
  Model flat = membrane_in_box(sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 11, 11), shape);
  flat.pressures.push_back({"membrane", [&](double t) { return p + t; }});
  CHECK(resultant(std::move(flat)).isApprox(Vector3d(0, 0, 4 * p), 1e-12));
}

TEST_CASE("Pressure inflates a sphere evenly") {
  Model model = membrane_in_box(icosphere(Vector3d::Zero(), 1, 4));
  const double p = 7, dt = 1e-4;
  model.pressures.push_back({"membrane", [&](double) { return p; }});
  Solver solver(std::move(model), dt);
  solver.step();
  double work_per_distance = 0;
  const auto& points = solver.bodies()[0].points;
  for (int i = 0; i < points.size(); ++i)
    work_per_distance += points.velocity_of(i).dot(points.position_of(i).normalized()) / dt;
  // The grid smooths over a cell of 0.375: its shape functions average the outward unit vector.
  CHECK(work_per_distance == Approx(4 * M_PI * p).epsilon(0.05));
}

TEST_CASE("Impossible loads are refused") {
  const auto one = [](double) { return 1.0; };
  const auto push = [](double) { return Vector3d(1, 0, 0); };
  const Box everywhere{{-2, -2, -2}, {2, 2, 2}};
  const Model model = membrane_in_box(dome());
  const auto refused = [&](auto change, const std::string& what) {
    Model with = model;
    change(with);
    CHECK_THROWS_WITH(Solver(std::move(with), 1e-4), Catch::Contains(what));
  };
  refused([&](Model& m) { m.pressures.push_back({"nobody", one}); }, "'nobody'");
  refused([&](Model& m) { m.pressures.push_back({"membrane", {}}); }, "no value");
  refused([&](Model& m) { m.forces.push_back({"membrane", everywhere, {}}); }, "no value");
  refused(
      [&](Model& m) {
        m.forces.push_back({"membrane", {{1.1, 0, 0}, {2, 1, 1}}, push});
      },
      "no points in");
  refused(
      [&](Model& m) {
        m.held.push_back({{{0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}}, {}, {}});
      },
      "no node");
  refused(
      [&](Model& m) {
        auto points = make_points({{0, 0, 0}}, {1});
        Prescribed rigid(points, 1000);
        m.bodies.push_back({"rigid", std::move(points), std::move(rigid), {}});
        m.forces.push_back({"rigid", everywhere, push});
      },
      "motion is prescribed");
  refused(
      [&](Model& m) {
        auto points = make_points({{0, 0, 0}}, {1});
        LinearElastic solid({1000, 1e6, 0}, 1);
        m.bodies.push_back({"solid", std::move(points), std::move(solid), {}});
        m.pressures.push_back({"solid", one});
      },
      "is no membrane");
}
