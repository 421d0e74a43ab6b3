#pragma once

#include "mpm/cell_index.h"
#include "mpm/material_points.h"

namespace zona::mpm {

/// Trilinear shape functions of a cell (3.7)-(3.11), node n at the corner whose offsets are n's
/// bits. With natural coordinates xi, eta, zeta in [0, 1], N_n is the product of xi or 1 - xi, and
/// so on.
namespace trilinear {

inline constexpr Lanes sign_x{-1, 1, -1, 1, -1, 1, -1, 1};
inline constexpr Lanes sign_y{-1, -1, 1, 1, -1, -1, 1, 1};
inline constexpr Lanes sign_z{-1, -1, -1, -1, 1, 1, 1, 1};
inline constexpr Lanes at_zero_x{1, 0, 1, 0, 1, 0, 1, 0};
inline constexpr Lanes at_zero_y{1, 1, 0, 0, 1, 1, 0, 0};
inline constexpr Lanes at_zero_z{1, 1, 1, 1, 0, 0, 0, 0};

/// The three factors of a point's eight shape functions; their product is N, and a factor replaced
/// by its sign gives a derivative with respect to that natural coordinate.
struct Factors {
  Lanes x, y, z;
};

inline Factors factors(double xi, double eta, double zeta) {
  return {at_zero_x + sign_x * xi, at_zero_y + sign_y * eta, at_zero_z + sign_z * zeta};
}

/// From nodal values to the coefficients of 1, xi, eta, xi eta, zeta, xi zeta, eta zeta, xi eta
/// zeta (index bits as for nodes), so that eight points at once are interpolated by Horner's rule.
template <class Value>
void to_coefficients(Value (&c)[8]) {
  for (int bit = 1; bit < 8; bit *= 2) {
    for (int n = 0; n < 8; ++n) {
      if (n & bit) c[n] -= c[n ^ bit];
    }
  }
}

/// The value at natural coordinates s of eight points; c[k] are a field's eight coefficients with a
/// stride between them.
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

}  // namespace trilinear

/// A cell as the kernels see it: its lowest corner and its nodes.
struct Cell {
  std::array<double, 3> corner;   ///< [m]
  std::array<double, 3> inverse;  ///< 1 / cell size [1/m]
  int first_node;
  std::array<int, 3> index;

  /// Natural coordinates of eight points in [0, 1].
  std::array<Lanes, 3> natural(const std::array<Lanes, 3>& position) const {
    return {(position[0] - corner[0]) * inverse[0], (position[1] - corner[1]) * inverse[1],
            (position[2] - corner[2]) * inverse[2]};
  }
  /// The same of one place [m].
  std::array<double, 3> natural(const Eigen::Vector3d& place) const {
    return {(place[0] - corner[0]) * inverse[0], (place[1] - corner[1]) * inverse[1],
            (place[2] - corner[2]) * inverse[2]};
  }
};

inline Cell make_cell(const BackgroundGrid& grid, const Brick& brick, int cell_in_brick) {
  constexpr int e = Brick::edge;
  const std::array<int, 3> index{brick.first_cell[0] + cell_in_brick % e,
                                 brick.first_cell[1] + cell_in_brick / e % e,
                                 brick.first_cell[2] + cell_in_brick / (e * e)};
  Cell cell{{}, {}, grid.node_index(index[0], index[1], index[2]), index};
  for (int axis = 0; axis < 3; ++axis) {
    cell.corner[axis] = grid.origin()[axis] + index[axis] * grid.cell_size()[axis];
    cell.inverse[axis] = 1 / grid.cell_size()[axis];
  }
  return cell;
}

/// Calls f(Cell, begin, end, cell_in_brick) for each cell of a brick that holds points.
template <class F>
void for_each_cell(const BackgroundGrid& grid, int b, const BrickPoints& points, F f) {
  for (int c = 0; c < Brick::cell_count; ++c) {
    const int begin = points.begin[c];
    const int end = points.begin[c + 1];
    if (begin < end)
      f(make_cell(grid, grid.bricks()[b], c), points.points.data() + begin,
        points.points.data() + end, c);
  }
}

}  // namespace zona::mpm
