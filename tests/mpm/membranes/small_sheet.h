#pragma once

#include <Eigen/Core>

#include "mpm/bodies/lattice.h"
#include "mpm/membranes/membrane.h"

/// A flat sheet of 6 x 5 points in the x-y plane, as soft as a zona, with prescribed deformation.
struct SmallSheet {
  zona::mpm::MaterialPoints points;
  zona::mpm::Membrane membrane;
  double time = 0;

  SmallSheet(bool objective, const zona::mpm::MembraneLaw& law = {},
             zona::mpm::OneWay one_way = zona::mpm::OneWay::off)
      : SmallSheet(zona::mpm::sheet(Eigen::Vector3d::Zero(), Eigen::Vector3d(1e-4, 0, 0),
                                    Eigen::Vector3d(0, 1e-4, 0), 6, 5),
                   objective, law, one_way) {}
  SmallSheet(const zona::mpm::TriangulatedSurface& s, bool objective,
             const zona::mpm::MembraneLaw& law, zona::mpm::OneWay one_way)
      : points(zona::mpm::make_points(s.places, std::vector<double>(s.places.size(), 1e-12))),
        membrane({1100, 8e-6, 17.9e3, 0.49, one_way}, law, objective, points, s.triangles) {}

  /// Moves the points to f times their initial positions.
  void deform(const Eigen::Matrix3d& f, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
    auto moved = points.position;
    for (int p = 0; p < points.size(); ++p) {
      const Eigen::Vector3d x = f * points.position_of(p) + shift;
      for (int c = 0; c < 3; ++c) moved[c][p] = x[c];
    }
    time += 1;
    membrane.update_stress(moved, time, 1);
  }
  /// Principal stretches minus one along x and y, and shear: strain of the points without rotation.
  void strain(double xx, double yy, double xy = 0) {
    Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
    f(0, 0) += xx;
    f(1, 1) += yy;
    f(0, 1) = f(1, 0) = xy;
    deform(f);
  }
  Eigen::Matrix3d stress(int p = 7) const {
    const auto& s = membrane.stress;
    Eigen::Matrix3d m;
    m << s[0][p], s[3][p], s[5][p], s[3][p], s[1][p], s[4][p], s[5][p], s[4][p], s[2][p];
    return m;
  }
  double largest_stress() const {
    double largest = 0;
    for (const auto& component : membrane.stress) {
      for (double s : component) largest = std::max(largest, std::abs(s));
    }
    return largest;
  }
};
