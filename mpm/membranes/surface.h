#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mpm/points/material_points.h"

namespace zona::mpm {

/// Indices of the vertices, by the right-hand rule about the normal.
using Triangle = std::array<int, 3>;

/// Lanes of a 3-vector.
using VectorLanes = std::array<Lanes, 3>;

/// a . b
inline Lanes dot(const VectorLanes& a, const VectorLanes& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// a x b
inline VectorLanes cross(const VectorLanes& a, const VectorLanes& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// s a
inline VectorLanes scaled(const VectorLanes& a, const Lanes& s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}

/// A triangulated surface whose vertices are the points of a membrane (4.1). By the right-hand rule
/// the normals of its triangles point outward. Triangles with a failed vertex are dropped.
class Surface {
 public:
  /// Throws ModelError for vertices out of range, degenerate triangles or points in no triangle.
  Surface(std::vector<Triangle> triangles, const std::vector<Eigen::Vector3d>& places);

  const std::vector<Triangle>& triangles() const { return triangles_; }  ///< dropped ones too
  bool intact(int triangle) const { return intact_[triangle] != 0; }     ///< no vertex has failed
  /// @{
  /// Range of the triangles around a point, as indices into triangles().
  const int* triangles_begin(int point) const { return &around_[first_around_[point]]; }
  const int* triangles_end(int point) const { return around_.data() + first_around_[point + 1]; }
  /// @}
  /// One third of the area of the triangles around each point [m^2].
  std::vector<double> areas(const std::array<Field, 3>& position) const;

  /// Drops the triangles around a failed point. Returns the other vertices of those triangles.
  std::vector<int> drop_triangles_of(int point);

  /// Computes the unit normals of the intact triangles at these positions [m].
  void compute_normals(const std::array<Field, 3>& position, int threads);
  /// Sums of the computed triangle normals around eight points from `first` on, a multiple of
  /// eight. They are parallel to the point normals (4.12); zero for a point without intact
  /// triangles.
  VectorLanes normal_sum(int first) const;

 private:
  void pad_to_lanes();

  std::vector<Triangle> triangles_;
  std::vector<int> first_around_;
  std::vector<int> around_;
  // Arrays for eight triangles or points at once, padded to a multiple of eight. Missing triangles
  // refer to the last one, whose normal is zero.
  std::array<std::vector<int>, 3> vertex_;
  std::vector<std::vector<int>> column_;  ///< [k][p]: k-th triangle around point p
  Field intact_;                          ///< 1, or 0 once the triangle is dropped
  std::array<Field, 3> normal_;           ///< of each triangle; zero once it is dropped
};

}  // namespace zona::mpm
