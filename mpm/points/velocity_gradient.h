#pragma once

#include <array>

#include "mpm/points/material_points.h"

namespace zona::mpm {

/// dv_i/dx_j [1/s] of eight points: `gradient[i][j]`.
using VelocityGradient = std::array<std::array<Lanes, 3>, 3>;

/// Rate of strain (3.3) [1/s], tensor components xx yy zz xy yz zx.
inline SymmetricTensorLanes strain_rate(const VelocityGradient& l) {
  return {l[0][0],
          l[1][1],
          l[2][2],
          0.5 * (l[0][1] + l[1][0]),
          0.5 * (l[1][2] + l[2][1]),
          0.5 * (l[2][0] + l[0][2])};
}

/// W s - s W [unit of s per second] with the spin W = (dv_i/dx_j - dv_j/dx_i)/2: the rate of a
/// tensor that rotates with the material (Jaumann).
inline SymmetricTensorLanes turning_rate(const VelocityGradient& l, const SymmetricTensorLanes& s) {
  const Lanes wxy = 0.5 * (l[0][1] - l[1][0]);
  const Lanes wyz = 0.5 * (l[1][2] - l[2][1]);
  const Lanes wzx = 0.5 * (l[2][0] - l[0][2]);
  return {2.0 * (wxy * s[3] - wzx * s[5]),
          2.0 * (wyz * s[4] - wxy * s[3]),
          2.0 * (wzx * s[5] - wyz * s[4]),
          wxy * (s[1] - s[0]) + wyz * s[5] - wzx * s[4],
          wyz * (s[2] - s[1]) + wzx * s[3] - wxy * s[5],
          wzx * (s[0] - s[2]) + wxy * s[4] - wyz * s[3]};
}

/// Sum of the normal components.
inline Lanes trace(const SymmetricTensorLanes& a) {
  return a[0] + a[1] + a[2];
}

/// dv_i/dx_i [1/s].
inline Lanes divergence(const VelocityGradient& l) {
  return l[0][0] + l[1][1] + l[2][2];
}

/// The gradient with its divergence replaced; deviator and spin stay.
inline VelocityGradient with_divergence(VelocityGradient l, double other) {
  const Lanes change = (other - divergence(l)) / 3.0;
  for (int i = 0; i < 3; ++i) l[i][i] += change;
  return l;
}

/// a : b
inline Lanes contract(const SymmetricTensorLanes& a, const SymmetricTensorLanes& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

}  // namespace zona::mpm
