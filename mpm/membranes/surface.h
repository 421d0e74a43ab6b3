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

/// A triangulated surface whose vertices are the points of a membrane (4.1). Triangles are ordered
/// by the right-hand rule: their normals point outward. A triangle with a failed vertex is dropped.
class Surface {
 public:
  /// Throws ModelError for vertices out of range, degenerate triangles or points in no triangle.
  Surface(std::vector<Triangle> triangles, const std::vector<Eigen::Vector3d>& places);

  const std::vector<Triangle>& triangles() const { return triangles_; }  ///< dropped ones too
  bool intact(int triangle) const { return intact_[triangle] != 0; }     ///< no vertex has failed
  /// @{
  /// Triangles around a point, first and one past the last: indices into triangles().
  const int* triangles_begin(int point) const { return &around_[first_around_[point]]; }
  const int* triangles_end(int point) const { return around_.data() + first_around_[point + 1]; }
  /// @}
  /// A third of the area of the triangles around each point [m^2].
  std::vector<double> areas(const std::array<Field, 3>& position) const;

  /// Takes the triangles around a failed point out. Returns the other vertices of those triangles.
  std::vector<int> drop_triangles_of(int point);

  /// Unit normals of the intact triangles at the given positions, by `threads` threads.
  void find_normals(const std::array<Field, 3>& position, int threads);
  /// Sum of the normals found around the eight points from `first` on, a multiple of eight: along
  /// their point normals (4.12). Zero for a point without intact triangles.
  VectorLanes normal_sum(int first) const;

 private:
  void arrange_in_eights();

  std::vector<Triangle> triangles_;
  std::vector<int> first_around_;
  std::vector<int> around_;
  // The same for eight triangles or points at once, filled up to whole eights: missing triangles
  // are the last one, whose normal is zero.
  std::array<std::vector<int>, 3> vertex_;
  std::vector<std::vector<int>> column_;  ///< [k][p]: k-th triangle around point p
  Field intact_;                          ///< 1, or 0 once the triangle is dropped
  std::array<Field, 3> normal_;           ///< of each triangle; zero once it is dropped
};

}  // namespace zona::mpm
