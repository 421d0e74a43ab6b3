#pragma once

#include "mpm/grid/cell.h"
#include "mpm/points/velocity_gradient.h"

namespace zona::mpm {

/// Trilinear shape functions of a cell (3.7)-(3.11). Node n lies at the corner whose offsets are
/// the bits of n. With natural coordinates xi, eta, zeta in [0, 1], N_n is the product of xi or 1 -
/// xi, eta or 1 - eta, and zeta or 1 - zeta.
namespace trilinear {

/// @{
/// A factor of N is at_zero + sign xi, i.e. xi where the node's offset is 1, else 1 - xi.
inline constexpr Lanes sign_x{-1, 1, -1, 1, -1, 1, -1, 1};
inline constexpr Lanes sign_y{-1, -1, 1, 1, -1, -1, 1, 1};
inline constexpr Lanes sign_z{-1, -1, -1, -1, 1, 1, 1, 1};
inline constexpr Lanes at_zero_x{1, 0, 1, 0, 1, 0, 1, 0};
inline constexpr Lanes at_zero_y{1, 1, 0, 0, 1, 1, 0, 0};
inline constexpr Lanes at_zero_z{1, 1, 1, 1, 0, 0, 0, 0};
/// @}

/// The three factors of a point's eight shape functions. Their product is N; with one factor
/// replaced by its sign it is the derivative with respect to that natural coordinate.
struct Factors {
  Lanes x;  ///< along x, for the eight nodes [-]
  Lanes y;  ///< along y [-]
  Lanes z;  ///< along z [-]
};

/// Factors at natural coordinates in [0, 1].
inline Factors factors(double xi, double eta, double zeta) {
  return {at_zero_x + sign_x * xi, at_zero_y + sign_y * eta, at_zero_z + sign_z * zeta};
}

/// Converts nodal values to the coefficients of 1, xi, eta, xi eta, zeta, xi zeta, eta zeta, xi eta
/// zeta (index bits as for nodes). Horner's rule then interpolates eight points at once.
template <class Value>
void to_coefficients(Value (&c)[8]) {
  for (int bit = 1; bit < 8; bit *= 2) {
    for (int n = 0; n < 8; ++n) {
      if (n & bit) c[n] -= c[n ^ bit];
    }
  }
}

/// Values at the natural coordinates s of eight points; c[k stride] are the eight coefficients of a
/// field.
inline Lanes interpolate(const double* c, int stride, const std::array<Lanes, 3>& s) {
  const auto at = [&](int k) { return c[k * stride]; };
  const Lanes low = at(0) + at(1) * s[0] + s[1] * (at(2) + at(3) * s[0]);
  const Lanes high = at(4) + at(5) * s[0] + s[1] * (at(6) + at(7) * s[0]);
  return low + s[2] * high;
}

/// Derivatives with respect to the natural coordinates.
inline std::array<Lanes, 3> derivatives(const double* c, int stride,
                                        const std::array<Lanes, 3>& s) {
  const auto at = [&](int k) { return c[k * stride]; };
  return {at(1) + at(3) * s[1] + s[2] * (at(5) + at(7) * s[1]),
          at(2) + at(3) * s[0] + s[2] * (at(6) + at(7) * s[0]),
          at(4) + at(5) * s[0] + s[1] * (at(6) + at(7) * s[0])};
}

/// Sums over the points of a cell for its eight nodes, in registers.
class NodalSums {
 public:
  /// All sums are zero.
  NodalSums(const BackgroundGrid&, const Cell&) {}

  /// Adds mass, momentum and, if `with_stress`, internal force of point p of a group.
  template <bool with_stress>
  void add(const PointContributions& points, int p) {
    const auto n = factors(points.natural[0][p], points.natural[1][p], points.natural[2][p]);
    const Lanes yz = n.y * n.z;
    const Lanes shape = n.x * yz;
    mass_ += points.mass[p] * shape;
    for (int i = 0; i < 3; ++i) momentum_[i] += points.momentum[i][p] * shape;
    if constexpr (with_stress) {
      const Lanes xz = n.x * n.z;
      const Lanes xy = n.x * n.y;
      for (int i = 0; i < 3; ++i) {
        force_x_[i] += points.stress[i][0][p] * yz;
        force_y_[i] += points.stress[i][1][p] * xz;
        force_z_[i] += points.stress[i][2][p] * xy;
      }
    }
  }

  /// Adds the sums to the nodes, and the mass times the wave speeds [m/s].
  void add_to_nodes(const Cell& cell, double wave_speed, double shear_wave_speed,
                    BackgroundGrid& grid) const {
    if (shear_wave_speed > 0) {
      for (int n = 0; n < 8; ++n) {
        grid.updated[cell.first_node + grid.node_offsets()[n]][3] += shear_wave_speed * mass_[n];
      }
    }
    Lanes row[8];
    row[0] = mass_;
    for (int i = 0; i < 3; ++i) {
      row[1 + i] = momentum_[i];
      row[4 + i] = sign_x * force_x_[i] + sign_y * force_y_[i] + sign_z * force_z_[i];
    }
    row[7] = wave_speed * mass_;
    transpose(row);
    for (int n = 0; n < 8; ++n) grid.state[cell.first_node + grid.node_offsets()[n]] += row[n];
  }

 private:
  Lanes mass_{};
  Lanes momentum_[3]{};
  Lanes force_x_[3]{};  ///< stress terms with dN/dxi, without the sign of the node
  Lanes force_y_[3]{};  ///< with dN/deta
  Lanes force_z_[3]{};  ///< with dN/dzeta
};

/// Sums of one vector per point over the points of a cell, for its eight nodes.
class VectorSums {
 public:
  /// All sums are zero.
  VectorSums(const BackgroundGrid&, const Cell&) {}

  /// Adds the vector of point p of a group.
  void add(const PointVectors& points, int p) {
    const auto n = factors(points.natural[0][p], points.natural[1][p], points.natural[2][p]);
    const Lanes shape = n.x * n.y * n.z;
    for (int axis = 0; axis < 3; ++axis) sum_[axis] += points.vector[axis][p] * shape;
  }
  /// Calls f(node, sum) for the nodes of the cell; the fourth number of a sum is zero.
  template <class F>
  void for_each_node(const Cell& cell, const BackgroundGrid& grid, F f) {
    transpose(sum_);
    for (int n = 0; n < 8; ++n) {
      f(cell.first_node + grid.node_offsets()[n], low_half(sum_[n]));
    }
  }

 private:
  Lanes sum_[8]{};
};

/// Velocity and acceleration of the grid within one cell, as coefficients: [coefficient][field],
/// fields as in BackgroundGrid::state.
class CellField {
 public:
  /// Loads the nodes of the cell.
  CellField(const BackgroundGrid& grid, const Cell& cell) {
    Lanes node[8];
    for (int n = 0; n < 8; ++n) node[n] = grid.state[cell.first_node + grid.node_offsets()[n]];
    to_coefficients(node);
    for (int n = 0; n < 8; ++n) store(c_[n], node[n]);
  }
  /// @{
  /// Velocity [m/s] or acceleration [m/s^2] of eight points at natural coordinates in [0, 1].
  Lanes velocity(int axis, const std::array<Lanes, 3>& natural) const {
    return interpolate(&c_[0][1 + axis], lane_count, natural);
  }
  Lanes acceleration(int axis, const std::array<Lanes, 3>& natural) const {
    return interpolate(&c_[0][4 + axis], lane_count, natural);
  }
  /// @}

 private:
  alignas(64) double c_[8][lane_count];
};

/// Velocity gradient of the updated nodal velocities (3.40) at the points of one cell.
class CellGradient {
 public:
  /// Loads the updated nodes of the cell.
  CellGradient(const BackgroundGrid& grid, const Cell& cell) : inverse_(cell.inverse) {
    HalfLanes node[8];
    for (int n = 0; n < 8; ++n) node[n] = grid.updated[cell.first_node + grid.node_offsets()[n]];
    to_coefficients(node);
    __builtin_memcpy(c_, node, sizeof(c_));
  }
  /// Gradient at eight points with natural coordinates in [0, 1].
  VelocityGradient at(const std::array<Lanes, 3>& natural) const {
    VelocityGradient gradient;
    for (int i = 0; i < 3; ++i) {
      gradient[i] = derivatives(&c_[0][i], 4, natural);
      for (int j = 0; j < 3; ++j) gradient[i][j] *= inverse_[j];
    }
    return gradient;
  }

 private:
  alignas(64) double c_[8][4];
  std::array<double, 3> inverse_;
};

}  // namespace trilinear

/// Policy of Interpolation::linear, see shape_functions.h.
struct Trilinear {
  /// @{
  /// Kernels of the policy.
  using NodalSums = trilinear::NodalSums;
  using VectorSums = trilinear::VectorSums;
  using CellField = trilinear::CellField;
  using CellGradient = trilinear::CellGradient;
  /// @}
  /// Cells with at most this many points go into a batch (trilinear_batch.h).
  static constexpr int few_points = 4;
};

}  // namespace zona::mpm
