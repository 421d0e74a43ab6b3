#include "mpm/materials/decohesion.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

#include "mpm/materials/von_mises_solid.h"
#include "mpm/points/errors.h"
#include "tests/mpm/materials/solid_point.h"

using namespace zona::mpm;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Area of the section of a box by a plane through its middle, by counting points of the box in a
/// thin slab.
double section_area(const Vector3d& n, const Vector3d& cell) {
  const double slab = 0.02 * cell.minCoeff();
  const int count = 150;
  long inside = 0;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      for (int k = 0; k < count; ++k) {
        const Vector3d x = cell.cwiseProduct((Vector3d(i, j, k).array() + 0.5).matrix() / count -
                                             Vector3d::Constant(0.5));
        inside += std::abs(x.dot(n)) < slab;
      }
    }
  }
  return cell.prod() * static_cast<double>(inside) / std::pow(count, 3) / (2 * slab);
}

const ElasticProperties glassy{1000, 1e9, 0.3};

/// Yields, and softens enough to localise in any state.
VonMises brittle(double mode_ratio, double cell, double exponent = 1) {
  VonMises law{1e6, 1.01e6, 1e8, 5e9, Decohesion{}};
  law.decohesion->reference_opening = 1e-6;
  law.decohesion->exponent = exponent;
  law.decohesion->mode_ratio = mode_ratio;
  law.decohesion->cell.setConstant(cell);
  return law;
}

Matrix3d stretch(double xx, double yy, double zz) {
  return Vector3d(xx, yy, zz).asDiagonal();
}

}  // namespace

TEST_CASE("The effective length is the cell's volume over the section's area") {
  const Vector3d cube = Vector3d::Constant(6e-6);
  CHECK(effective_length(Vector3d::UnitX(), cube) == Approx(6e-6));
  CHECK(effective_length(Vector3d(1, 1, 0).normalized(), cube) == Approx(6e-6 / std::sqrt(2)));
  CHECK(effective_length(Vector3d(1, 1, 1).normalized(), cube) ==
        Approx(6e-6 / (0.75 * std::sqrt(3.0))));  // a regular hexagon
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  const Vector3d cell(1, 0.7, 1.6);
  for (int trial = 0; trial < 4; ++trial) {
    const Vector3d n = Vector3d(normal(random), normal(random), normal(random)).normalized();
    // The slab's thickness and 150 points an edge resolve the area to some percents.
    CHECK(effective_length(n, cell) == Approx(cell.prod() / section_area(n, cell)).epsilon(0.03));
  }
}

TEST_CASE("(5.40) holds where the surface appears; the ratio of its strengths is c_m") {
  for (double ratio : {10.0, 1.0, 0.1}) {
    Decohesion m;
    m.mode_ratio = ratio;
    const DecohesionSurface s = surface_at(m, {3, 4});
    const double shear = ratio * s.tensile_strength;
    CHECK(9 / (s.tensile_strength * s.tensile_strength) + 16 / (shear * shear) == Approx(1));
    CHECK(s.reference_traction == Approx(5));
    CHECK(decohesion_flow(m, s, {3, 4}).effective == Approx(m.reference_opening * 5));
    CHECK(s.energy(m) == Approx(0.5 * 1e-8 * 5));
    // tau . m is tau^e (5.38).
    const auto flow = decohesion_flow(m, s, {3, 4});
    CHECK(3 * flow.direction.normal + 4 * flow.direction.tangential == Approx(flow.effective));
  }
}

TEST_CASE("c_m = 10 opens the surface, 0.1 slides it, 1 follows the traction") {
  Decohesion m;
  const auto tangential_share = [&](double ratio) {
    m.mode_ratio = ratio;
    const auto flow = decohesion_flow(m, surface_at(m, {1, 1}), {1, 1}).direction;
    return flow.tangential / std::hypot(flow.normal, flow.tangential);
  };
  CHECK(tangential_share(10) == Approx(0.01).epsilon(1e-3));  // mode I
  CHECK(tangential_share(1) == Approx(std::sqrt(0.5)));       // mixed
  CHECK(tangential_share(0.1) == Approx(1).epsilon(1e-3));    // mode II
}

TEST_CASE("Compression neither fails a surface nor opens it") {
  Decohesion m;
  const DecohesionSurface s = surface_at(m, {-5, 2});
  CHECK(s.tensile_strength == Approx(0.2));
  const auto flow = decohesion_flow(m, s, {-50, 2});
  CHECK(flow.direction.normal == 0);
  CHECK(flow.effective == Approx(m.reference_opening * 2));
  CHECK(decohesion_flow(m, s, {-50, 0}).effective == 0);
}

TEST_CASE("The one-step update, and complete failure where it snaps back") {
  Decohesion m;
  const DecohesionSurface s = surface_at(m, {1000, 0});
  const double initial = 1e-8 * 1000;
  const auto increment = [&](double lambda, double effective, double relief) {
    return decohesion_increment(m, s, lambda, effective * initial, relief * initial, HUGE_VAL);
  };
  CHECK(increment(0, 0.999, 10) == 0);
  CHECK(increment(0, 1.1, 3) == Approx(0.05));
  CHECK(increment(0.6, 0.5, 3) == Approx(0.05));
  CHECK(increment(0.25, 1.1, 1) == 0.75);
  CHECK(increment(0.25, 1.1, 0.1) == 0.75);
  CHECK(increment(0.25, 5, 2) == 0.75);
  CHECK(decohesion_increment(m, s, 0, 1.1 * initial, 3 * initial, 0.01) == 0.01);
  // The zona: E' u_0 / tau_0 is 0.22 um, far below any cell.
  const ElasticModuli zona{17.9e3, 0.49};
  const double longest = longest_resolved_length(m, surface_at(m, {1062.805, 0}), {1062.805, 0},
                                                 {zona.plane_stress(), zona.shear()});
  CHECK(longest == Approx(zona.plane_stress() * 1e-8 / 1062.805));
  CHECK(longest == Approx(0.22e-6).epsilon(0.01));
}

TEST_CASE("A surface pulled open along its preferred direction: F = 0, energy u0 tau0 q/(q + 1)") {
  for (const auto& [ratio, exponent] :
       {std::pair(10.0, 1.0), std::pair(1.0, 1.0), std::pair(0.1, 1.0), std::pair(1.0, 2.0)}) {
    INFO("c_m " << ratio << ", q " << exponent);
    const VonMises law = brittle(ratio, 1e-6, exponent);
    SolidPoint<VonMises> point(glassy, law);
    const auto& surfaces = point.solid.state.surfaces;
    while (!surfaces.surface(0).present()) point.step(stretch(1e-6, -1e-7, -1e-7));
    const Vector3d n(surfaces.normal[0][0], surfaces.normal[1][0], surfaces.normal[2][0]);
    const double initial = 1e-6 * surfaces.reference_traction[0];
    for (int s = 0; s < 2000000 && !point.solid.state.failed(0); ++s) {
      const Vector3d t = point.stress() * n;
      const double along = n.dot(t), across = (t - along * n).norm();
      const auto flow = decohesion_flow(*law.decohesion, surfaces.surface(0), {along, across});
      const double left = 1 - std::pow(surfaces.opened[0], exponent);
      REQUIRE(flow.effective / initial - left < 1e-9);  // (5.41) ends at 1e-10, and rounding
      const Vector3d m =
          flow.direction.normal * n + flow.direction.tangential * (t - along * n).normalized();
      const Matrix3d opening = n * m.normalized().transpose();
      point.step(4e-6 * (opening + opening.transpose()));
    }
    REQUIRE(point.solid.state.failed(0));
    CHECK(point.stress().norm() == 0);
    // First order in the step, 1 %, and what is stored along the surface when it fails.
    CHECK(surfaces.dissipated[0] ==
          Approx(surfaces.surface(0).energy(*law.decohesion)).epsilon(0.015));
    CHECK(surfaces.surface(0).energy(*law.decohesion) ==
          Approx(initial * exponent / (exponent + 1)));
  }
}

TEST_CASE("Beyond the longest resolved length a point fails at once and releases all it stored") {
  const VonMises law = brittle(10, 1e-2);
  SolidPoint<VonMises> point(glassy, law);
  double stored = 0;
  int s = 0;
  for (; s < 2000 && !point.solid.state.failed(0); ++s) {
    const Matrix3d stress = point.stress();
    stored = (1.3 * stress.squaredNorm() - 0.3 * std::pow(stress.trace(), 2)) / 2e9;
    point.step(stretch(1, -0.3, -0.3) / 100000);
  }
  REQUIRE(point.solid.state.failed(0));
  const auto& surfaces = point.solid.state.surfaces;
  CHECK(surfaces.opened[0] == 1);
  const Vector3d n(surfaces.normal[0][0], surfaces.normal[1][0], surfaces.normal[2][0]);
  CHECK(surfaces.dissipated[0] ==
        Approx(stored * effective_length(n, law.decohesion->cell)).epsilon(0.05));
  CHECK(surfaces.dissipated[0] > 10 * surfaces.surface(0).energy(*law.decohesion));
}

TEST_CASE("The surface turns with the body") {
  const VonMises law = brittle(1, 1e-5);
  SolidPoint<VonMises> point(glassy, law);
  const auto& surfaces = point.solid.state.surfaces;
  while (!surfaces.surface(0).present()) point.step(stretch(1e-5, -3e-6, -3e-6));
  const auto normal = [&] {
    return Vector3d(surfaces.normal[0][0], surfaces.normal[1][0], surfaces.normal[2][0]);
  };
  const Vector3d before = normal();
  const double opened = surfaces.opened[0];
  Matrix3d spin = Matrix3d::Zero();
  const int steps = 2000;
  spin(0, 1) = -1.0 / steps;
  spin(1, 0) = 1.0 / steps;
  point.step(stretch(-1e-4, 0, 0));  // unloads first
  for (int s = 0; s < steps; ++s) point.step(spin);
  const Matrix3d r = Eigen::AngleAxisd(1, Vector3d::UnitZ()).toRotationMatrix();
  CHECK((normal() - r * before).norm() < 1e-3);
  CHECK(normal().norm() == Approx(1).epsilon(1e-14));
  CHECK(surfaces.opened[0] == opened);
}

TEST_CASE("A closed surface carries compression and can slide") {
  const VonMises law = brittle(1, 1e-5);
  SolidPoint<VonMises> point(glassy, law);
  const auto& surfaces = point.solid.state.surfaces;
  for (int s = 0; s < 4000; ++s) point.step(stretch(1e-5, -3e-6, -3e-6));
  REQUIRE(surfaces.opened[0] > 0.1);
  REQUIRE_FALSE(point.solid.state.failed(0));
  const double opened = surfaces.opened[0];
  for (int s = 0; s < 100; ++s) point.step(stretch(-1e-4, -1e-4, -1e-4));
  CHECK(surfaces.opened[0] == opened);
  CHECK(point.stress().trace() / 3 < -1e6);
}

TEST_CASE("Invalid decohesion is refused") {
  Decohesion m;
  CHECK_NOTHROW(check(m));
  m.exponent = 0.5;
  CHECK_THROWS_WITH(check(m), Catch::Contains("at least 1"));
  m = {};
  m.reference_opening = 0;
  CHECK_THROWS_AS(check(m), ModelError);
  m = {};
  m.mode_ratio = -1;
  CHECK_THROWS_AS(check(m), ModelError);
  m = {};
  m.cell.y() = 0;
  CHECK_THROWS_AS(check(m), ModelError);
  m = {};
  m.reference_traction = -1;
  CHECK_THROWS_AS(check(m), ModelError);
}
