#pragma once

#include <Eigen/Core>

namespace zona::mpm {

/// A closed cuboid with edges along the axes [m]; flat where `low` equals `high`.
struct Box {
  Eigen::Vector3d low;   ///< lowest corner [m]
  Eigen::Vector3d high;  ///< highest corner [m]

  /// True if a place [m] lies in the box, with a margin of 1e-9 of its longest edge.
  bool contains(const Eigen::Vector3d& place) const {
    const double margin = 1e-9 * (high - low).maxCoeff();
    return ((place - low).array() >= -margin).all() && ((high - place).array() >= -margin).all();
  }
};

}  // namespace zona::mpm
