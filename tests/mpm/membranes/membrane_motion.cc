#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "mpm/bodies/lattice.h"
#include "mpm/step/solver.h"

using namespace zona::mpm;
using Eigen::Vector3d;

namespace {

/// Largest and smallest in-plane principal strain [-] of the inner part of a square sheet, so soft
/// that it flies freely, after its points moved for 1 ms at v = (0, 0, tilting y) + a translation:
/// its slope is then s = tilting * 1 ms.
double strain_after_tilting(bool objective, double tilting) {
  const double cell = 8e-6, side = 8e-5;
  BackgroundGrid grid(Vector3d::Constant(-8e-5), Vector3d::Constant(cell), {20, 20, 20});
  const auto s = sheet(Vector3d(-side / 2, -side / 2, 0.3 * cell), Vector3d(side, 0, 0),
                       Vector3d(0, side, 0), 41, 41);
  auto points = make_points(s.places, std::vector<double>(s.places.size(), 1e-14));
  for (int p = 0; p < points.size(); ++p) {
    const Vector3d v(0.002, 0.003, -0.001 + tilting * points.position[1][p]);
    for (int axis = 0; axis < 3; ++axis) points.velocity[axis][p] = v[axis];
  }
  Membrane membrane({1100, 8e-6, 1e-6, 0.49, OneWay::stress}, {}, objective, points, s.triangles);
  Model model{grid, {}, {}, Vector3d::Zero()};
  model.bodies.push_back({"sheet", std::move(points), std::move(membrane), {}});
  Solver solver(std::move(model), 1e-6);
  while (solver.time() < 1e-3 - 1e-9) solver.step();
  double largest = 0;
  for (int p = 0; p < 41 * 41; ++p) {
    if (s.places[p].cwiseAbs().maxCoeff() > side / 4) continue;
    largest = std::max(largest, std::abs(solver.bodies()[0].membrane()->strain[p]));
  }
  return largest;
}

}  // namespace

TEST_CASE("A membrane in translation is not strained") {
  for (bool objective : {false, true}) CHECK(strain_after_tilting(objective, 0) < 1e-10);
}

TEST_CASE("A tilted sheet: objective kinematics see its stretch, the source's twice as much") {
  for (double s :
       {0.05, 0.1}) {  // steeper sheets span several cells, and averaging on the grid adds percents
    // Exact: lines along y are stretched to sqrt(1 + s^2).
    CHECK(strain_after_tilting(true, s / 1e-3) == Approx(std::sqrt(1 + s * s) - 1).epsilon(0.01));
    // (4.10): the accumulated shear e_yz = s / 2 seen along the slope.
    CHECK(strain_after_tilting(false, s / 1e-3) == Approx(s * s / (1 + s * s)).epsilon(0.01));
  }
}
