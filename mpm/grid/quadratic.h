#pragma once

#include "mpm/grid/cell.h"
#include "mpm/points/velocity_gradient.h"

namespace zona::mpm {

/// Quadratic B-splines with knots at the cell faces and open ends at the faces of the grid.
///
/// All points of a cell share 27 functions, products of three functions per axis. With the natural
/// coordinate xi in [0, 1] these are
///
///     N_0 = a (1 - xi)^2,   N_1 = 1 - N_0 - N_2,   N_2 = b xi^2,
///
/// where a and b are 1/2, except that a is 1 in the first and b is 1 in the last cell of an axis.
/// Function n = i + 3 j + 9 k is N_i(xi) N_j(eta) N_k(zeta). The gradient is continuous between
/// cells. At a face of the grid the outermost function is one and all others are zero.
namespace quadratic {

inline constexpr int node_count = 27;  ///< of a cell

/// a and b along each axis.
struct Knots {
  double low[3];   ///< a [-]
  double high[3];  ///< b [-]

  /// Values for a cell of the grid.
  Knots(const BackgroundGrid& grid, const Cell& cell) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = cell.index[axis] == 0 ? 1 : 0.5;
      high[axis] = cell.index[axis] == grid.cells()[axis] - 1 ? 1 : 0.5;
    }
  }
};

/// The three functions of one axis and their derivatives with respect to its natural coordinate.
struct Weights {
  double value[3];  ///< N_0, N_1, N_2 [-]
  double slope[3];  ///< of each [-]
};

/// Functions of an axis at its natural coordinate s in [0, 1].
inline Weights weights(const Knots& knots, int axis, double s) {
  const double r = 1 - s;
  const double a = knots.low[axis];
  const double b = knots.high[axis];
  Weights w;
  w.value[0] = a * r * r;
  w.value[2] = b * s * s;
  w.value[1] = 1 - w.value[0] - w.value[2];
  w.slope[0] = -2 * a * r;
  w.slope[2] = 2 * b * s;
  w.slope[1] = -w.slope[0] - w.slope[2];
  return w;
}

/// Converts nodal values to the coefficients of xi^i eta^j zeta^k, with the same index i + 3 j + 9
/// k. Horner's rule then interpolates eight points at once.
template <class Value>
void to_coefficients(const Knots& knots, Value (&c)[node_count]) {
  int stride = 1;
  for (int axis = 0; axis < 3; ++axis, stride *= 3) {
    for (int n = 0; n < node_count; ++n) {
      if (n / stride % 3 != 0) continue;
      const Value rise_low = knots.low[axis] * (c[n + stride] - c[n]);
      const Value rise_high = knots.high[axis] * (c[n + 2 * stride] - c[n + stride]);
      c[n] = c[n + stride] - rise_low;
      c[n + stride] = 2.0 * rise_low;
      c[n + 2 * stride] = rise_high - rise_low;
    }
  }
}

/// Values at the natural coordinates s of eight points; c[k stride] are the 27 coefficients of a
/// field.
inline Lanes interpolate(const double* c, int stride, const std::array<Lanes, 3>& s) {
  Lanes in_z{};
  for (int k = 2; k >= 0; --k) {
    Lanes in_y{};
    for (int j = 2; j >= 0; --j) {
      const double* row = c + (3 * j + 9 * k) * stride;
      in_y = in_y * s[1] + (row[0] + s[0] * (row[stride] + s[0] * row[2 * stride]));
    }
    in_z = in_z * s[2] + in_y;
  }
  return in_z;
}

/// Derivatives with respect to the natural coordinates.
inline std::array<Lanes, 3> derivatives(const double* c, int stride,
                                        const std::array<Lanes, 3>& s) {
  Lanes value{}, slope_x{}, slope_y{}, slope_z{};
  for (int k = 2; k >= 0; --k) {
    Lanes plane{}, plane_x{}, plane_y{};
    for (int j = 2; j >= 0; --j) {
      const double* row = c + (3 * j + 9 * k) * stride;
      const Lanes high = row[stride] + s[0] * row[2 * stride];
      plane_y = plane_y * s[1] + plane;
      plane = plane * s[1] + (row[0] + s[0] * high);
      plane_x = plane_x * s[1] + (high + s[0] * row[2 * stride]);
    }
    slope_z = slope_z * s[2] + value;
    value = value * s[2] + plane;
    slope_x = slope_x * s[2] + plane_x;
    slope_y = slope_y * s[2] + plane_y;
  }
  return {slope_x, slope_y, slope_z};
}

/// Sums over the points of a cell for its nodes, with the layout of BackgroundGrid::state.
class NodalSums {
 public:
  /// All sums are zero.
  NodalSums(const BackgroundGrid& grid, const Cell& cell) : knots_(grid, cell) {}

  /// Adds mass, momentum and, if `with_stress`, internal force of point p of a group.
  template <bool with_stress>
  void add(const PointContributions& points, int p) {
    const Weights x = weights(knots_, 0, points.natural[0][p]);
    const Weights y = weights(knots_, 1, points.natural[1][p]);
    const Weights z = weights(knots_, 2, points.natural[2][p]);
    const auto& m = points.momentum;
    const Lanes carried{points.mass[p], m[0][p], m[1][p], m[2][p], 0, 0, 0, 0};
    const auto stress = [&](int j) {
      const auto& s = points.stress;
      return Lanes{0, 0, 0, 0, s[0][j][p], s[1][j][p], s[2][j][p], 0};
    };
    for (int i = 0; i < 3; ++i) {
      Lanes along_x = x.value[i] * carried;
      Lanes across_y{}, across_z{};
      if constexpr (with_stress) {
        along_x += x.slope[i] * stress(0);
        across_y = x.value[i] * stress(1);
        across_z = x.value[i] * stress(2);
      }
      for (int j = 0; j < 3; ++j) {
        const Lanes in_plane = y.value[j] * along_x + y.slope[j] * across_y;
        const Lanes out_of_plane = y.value[j] * across_z;
        for (int k = 0; k < 3; ++k)
          row_[i + 3 * j + 9 * k] += z.value[k] * in_plane + z.slope[k] * out_of_plane;
      }
    }
  }

  /// Adds the sums to the nodes, and the mass times the wave speeds [m/s].
  void add_to_nodes(const Cell& cell, double wave_speed, double shear_wave_speed,
                    BackgroundGrid& grid) const {
    for (int n = 0; n < node_count; ++n) {
      const int node = cell.first_node + grid.node_offsets()[n];
      Lanes row = row_[n];
      row[7] = wave_speed * row[0];
      grid.state[node] += row;
      if (shear_wave_speed > 0) grid.updated[node][3] += shear_wave_speed * row[0];
    }
  }

 private:
  Knots knots_;
  Lanes row_[node_count]{};
};

/// Sums of one vector per point over the points of a cell, for its nodes.
class VectorSums {
 public:
  /// All sums are zero.
  VectorSums(const BackgroundGrid& grid, const Cell& cell) : knots_(grid, cell) {}

  /// Adds the vector of point p of a group.
  void add(const PointVectors& points, int p) {
    const Weights x = weights(knots_, 0, points.natural[0][p]);
    const Weights y = weights(knots_, 1, points.natural[1][p]);
    const Weights z = weights(knots_, 2, points.natural[2][p]);
    const HalfLanes vector{points.vector[0][p], points.vector[1][p], points.vector[2][p], 0};
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) {
        const HalfLanes in_row = z.value[k] * y.value[j] * vector;
        for (int i = 0; i < 3; ++i) sum_[i + 3 * j + 9 * k] += x.value[i] * in_row;
      }
    }
  }
  /// Calls f(node, sum) for the nodes of the cell; the fourth number of a sum is zero.
  template <class F>
  void for_each_node(const Cell& cell, const BackgroundGrid& grid, F f) const {
    for (int n = 0; n < node_count; ++n) f(cell.first_node + grid.node_offsets()[n], sum_[n]);
  }

 private:
  Knots knots_;
  HalfLanes sum_[node_count]{};
};

/// Velocity and acceleration of the grid within one cell, as coefficients: [coefficient][field],
/// fields as in BackgroundGrid::state.
class CellField {
 public:
  /// Loads the nodes of the cell.
  CellField(const BackgroundGrid& grid, const Cell& cell) {
    Lanes node[node_count];
    for (int n = 0; n < node_count; ++n)
      node[n] = grid.state[cell.first_node + grid.node_offsets()[n]];
    to_coefficients(Knots(grid, cell), node);
    for (int n = 0; n < node_count; ++n) store(c_[n], node[n]);
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
  alignas(64) double c_[node_count][lane_count];
};

/// Velocity gradient of the updated nodal velocities (3.40) at the points of one cell.
class CellGradient {
 public:
  /// Loads the updated nodes of the cell.
  CellGradient(const BackgroundGrid& grid, const Cell& cell) : inverse_(cell.inverse) {
    HalfLanes node[node_count];
    for (int n = 0; n < node_count; ++n)
      node[n] = grid.updated[cell.first_node + grid.node_offsets()[n]];
    to_coefficients(Knots(grid, cell), node);
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
  alignas(64) double c_[node_count][4];
  std::array<double, 3> inverse_;
};

}  // namespace quadratic

/// Policy of Interpolation::quadratic, see shape_functions.h.
struct Quadratic {
  /// @{
  /// Kernels of the policy.
  using NodalSums = quadratic::NodalSums;
  using VectorSums = quadratic::VectorSums;
  using CellField = quadratic::CellField;
  using CellGradient = quadratic::CellGradient;
  /// @}
  static constexpr int few_points = 0;  ///< no batches
};

}  // namespace zona::mpm
