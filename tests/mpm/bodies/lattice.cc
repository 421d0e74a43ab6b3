#include "mpm/bodies/lattice.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "mpm/points/errors.h"
#include "mpm/points/material_points.h"

using namespace zona::mpm;
using Eigen::Vector3d;

TEST_CASE("A subdivided icosahedron is a closed outward sphere") {
  const auto sphere = icosphere(Vector3d(1, 2, 3), 0.5, 4);
  CHECK(sphere.places.size() == 10 * 256 + 2);
  CHECK(sphere.triangles.size() == 20 * 256);
  double area = 0, volume = 0;
  for (const auto& [a, b, c] : sphere.triangles) {
    const Vector3d o(1, 2, 3);
    const Vector3d n =
        0.5 * (sphere.places[b] - sphere.places[a]).cross(sphere.places[c] - sphere.places[a]);
    area += n.norm();
    volume += n.dot(sphere.places[a] - o) / 3;
  }
  // The inscribed polyhedron is second-order in the edge length h = 0.04: (h/R)^2/12 ~ 0.05 %...
  // 0.2 %.
  CHECK(area == Approx(4 * M_PI * 0.25).epsilon(0.002));
  CHECK(volume == Approx(4 * M_PI / 3 * 0.125).epsilon(0.004));
  CHECK(icosphere(Vector3d::Zero(), 1, 6).places.size() == 40962);
  CHECK(icosphere(Vector3d::Zero(), 1, 6).triangles.size() == 81920);
}

TEST_CASE("A disc is a fan of rings with one normal") {
  for (int axis = 0; axis < 3; ++axis) {
    const int rings = 5;
    const Vector3d center(1, 2, 3);
    const auto flat = disc(center, axis, 0.5, rings);
    CHECK(flat.places.size() == 1 + 3 * rings * (rings + 1));
    CHECK(flat.triangles.size() == 6 * rings * rings);
    Vector3d area = Vector3d::Zero();
    double sum = 0;
    for (const auto& [a, b, c] : flat.triangles) {
      const Vector3d n =
          0.5 * (flat.places[b] - flat.places[a]).cross(flat.places[c] - flat.places[a]);
      CHECK(n[axis] > 0);
      area += n;
      sum += n.norm();
    }
    // A regular polygon of 30 sides; all triangles have the same orientation.
    const double polygon = 0.5 * 30 * 0.25 * std::sin(2 * M_PI / 30);
    CHECK(sum == Approx(polygon));
    CHECK(area.isApprox(polygon * Vector3d::Unit(axis)));
    for (const Vector3d& place : flat.places) {
      CHECK(place[axis] == center[axis]);
      CHECK((place - center).norm() <= 0.5 * (1 + 1e-12));
    }
  }
}

TEST_CASE("Lattices represent the volume that they fill") {
  const BackgroundGrid grid(Vector3d::Zero(), Vector3d::Constant(0.1), {10, 10, 10});
  const auto all = fill_cells(grid, {2, 3, 1}, [](const Vector3d&) { return true; });
  CHECK(all.places.size() == 6000);
  CHECK(all.volume() == Approx(1));
  CHECK(box(Vector3d(0, 0, 0), Vector3d(1, 2, 3), {3, 4, 5}).volume() == Approx(6));
  const Tube wall{Vector3d(1, 0, 0), Vector3d::UnitX(), 15e-6, 4e-6, 5e-6};
  const auto points = tube(wall, 2, 60, 45);
  CHECK(points.places.size() == 5400);
  CHECK(points.volume() == Approx(M_PI * 9e-12 * 15e-6));  // exact: volumes at mid radius
  for (const auto& place : points.places) {
    const double r = std::hypot(place.y(), place.z());
    CHECK((r > 4e-6 && r < 5e-6 && place.x() > 1));
  }
}

TEST_CASE("Surfaces refuse invalid triangles") {
  const std::vector<Vector3d> places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  CHECK_THROWS_AS(Surface({{0, 1, 4}}, places), ModelError);
  CHECK_THROWS_AS(Surface({{0, 1, 2}}, places), ModelError);             // point 3 in no triangle
  CHECK_THROWS_AS(Surface({{0, 1, 2}, {0, 1, 3}}, places), ModelError);  // no area
}
