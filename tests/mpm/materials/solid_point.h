#pragma once

#include <Eigen/Core>

#include "mpm/materials/solid.h"

/// One point of a solid, driven by velocity gradients.
template <class Law>
struct SolidPoint {
  zona::mpm::Solid<Law> solid;

  SolidPoint(const zona::mpm::ElasticProperties& properties, const Law& law)
      : solid(properties, 1, law) {}

  void step(const Eigen::Matrix3d& increment_of_gradient) {
    zona::mpm::VelocityGradient l{};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) l[i][j] = zona::mpm::broadcast(increment_of_gradient(i, j));
    }
    const int point = 0;
    solid.update(zona::mpm::PointGroup(&point, 1), l, 1, 1);
  }
  Eigen::Matrix3d stress() const {
    const auto& s = solid.stress;
    Eigen::Matrix3d m;
    m << s[0][0], s[3][0], s[5][0], s[3][0], s[1][0], s[4][0], s[5][0], s[4][0], s[2][0];
    return m;
  }
  void set_stress(const Eigen::Matrix3d& m) {
    constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
    for (int c = 0; c < 6; ++c) solid.stress[c][0] = m(row[c], column[c]);
  }
};

/// sqrt(3 J2)
inline double equivalent_stress_of(const Eigen::Matrix3d& s) {
  const Eigen::Matrix3d deviator = s - s.trace() / 3 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}
