#pragma once

#include <Eigen/Core>
#include <functional>

namespace zona::mpm {

/// Translation of a body with prescribed motion, at one instant.
struct RigidState {
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();  ///< from the initial position [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< [m/s]
};

/// Motion as a function of time [s]; called once per step, never per point.
using RigidMotion = std::function<RigidState(double time)>;

}  // namespace zona::mpm
