#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mpm/points/lanes.h"

namespace zona::mpm {

/// A symmetric tensor per point, component order xx yy zz xy yz zx.
using SymmetricTensorField = std::array<Field, 6>;
/// A symmetric tensor of eight points, same order.
using SymmetricTensorLanes = std::array<Lanes, 6>;

/// Mass, position and velocity of the points of a body, one array per component.
struct MaterialPoints {
  std::array<Field, 3> position;       ///< [m]
  std::array<Field, 3> last_position;  ///< at the start of the running step [m]
  std::array<Field, 3> velocity;       ///< [m/s]
  Field mass;                          ///< [kg]
  /// Number of a point at its creation: storage is reordered, ids stay.
  std::vector<int> id;

  int size() const { return static_cast<int>(mass.size()); }  ///< number of points
  /// Position of the point stored at p [m].
  Eigen::Vector3d position_of(int p) const {
    return {position[0][p], position[1][p], position[2][p]};
  }
  /// Velocity of the point stored at p [m/s].
  Eigen::Vector3d velocity_of(int p) const {
    return {velocity[0][p], velocity[1][p], velocity[2][p]};
  }
  /// Storage index of each point, by id.
  std::vector<int> storage_by_id() const;
  /// Calls f(Field) for each field that a step changes, and for the mass.
  template <class F>
  void for_each_field(F f) {
    for (auto* group : {&position, &last_position, &velocity}) {
      for (auto& field : *group) f(field);
    }
    f(mass);
  }
};

/// Points at these places [m] with these masses [kg] and one velocity [m/s].
MaterialPoints make_points(const std::vector<Eigen::Vector3d>& places,
                           const std::vector<double>& mass,
                           const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero());

/// Up to eight points of one cell that are processed together. Spare lanes repeat the first point,
/// so that their results are finite; they are never stored.
class PointGroup {
 public:
  /// `count` points, 1 to 8, by their storage indices.
  PointGroup(const int* points, int count) : count_(count) {
    contiguous_ = true;
    for (int l = 0; l < lane_count; ++l) {
      point_[l] = points[l < count ? l : 0];
      contiguous_ = contiguous_ && (l >= count || point_[l] == point_[0] + l);
    }
  }
  /// Eight consecutive points.
  explicit PointGroup(int first) : count_(lane_count), contiguous_(true) {
    for (int l = 0; l < lane_count; ++l) point_[l] = first + l;
  }

  int count() const { return count_; }                     ///< points, without spare lanes
  int operator[](int lane) const { return point_[lane]; }  ///< storage index of a lane's point

  /// The values of the points.
  Lanes load(const Field& field) const {
    if (contiguous_) {
      const double* source = field.data() + point_[0];
      __builtin_prefetch(source + prefetch_distance);
      return count_ == lane_count ? mpm::load(source) : load_first(source, count_);
    }
    return each_lane([&](int l) { return field[point_[l]]; });
  }
  /// Stores the values of the points, without those of spare lanes.
  void store(Field& field, const Lanes& lanes) const {
    if (contiguous_) {
      double* target = field.data() + point_[0];
      __builtin_prefetch(target + prefetch_distance, 1);
      return store_first(target, lanes, count_);
    }
    for (int l = 0; l < count_; ++l) field[point_[l]] = lanes[l];
  }
  /// The same for the components of a vector.
  std::array<Lanes, 3> load(const std::array<Field, 3>& field) const {
    return {load(field[0]), load(field[1]), load(field[2])};
  }
  /// The same for the components of a symmetric tensor.
  SymmetricTensorLanes load(const SymmetricTensorField& field) const {
    return {load(field[0]), load(field[1]), load(field[2]),
            load(field[3]), load(field[4]), load(field[5])};
  }
  /// The same for the components of a vector or tensor.
  template <std::size_t N>
  void store(std::array<Field, N>& field, const std::array<Lanes, N>& lanes) const {
    for (std::size_t c = 0; c < N; ++c) store(field[c], lanes[c]);
  }

 private:
  /// Distance in points between the one that is loaded and the one that is prefetched. Storage is
  /// in traversal order, but has too many streams for the hardware prefetcher.
  static constexpr int prefetch_distance = 64;

  int point_[lane_count];
  int count_;
  bool contiguous_;
};

/// Up to eight consecutive points from `first` on, in a body of `count` points.
inline PointGroup consecutive(int first, int count) {
  if (count - first >= lane_count) return PointGroup(first);
  int points[lane_count];
  for (int l = 0; l < count - first; ++l) points[l] = first + l;
  return PointGroup(points, count - first);
}

/// Calls f(PointGroup) for the points [begin, end) of a cell, in their order.
template <class F>
void for_each_group(const int* begin, const int* end, F f) {
  for (; begin < end; begin += lane_count) {
    const auto left = end - begin;
    f(PointGroup(begin, left < lane_count ? static_cast<int>(left) : lane_count));
  }
}

}  // namespace zona::mpm
