#pragma once

#include <Eigen/Core>

#include "mpm/materials/rigid_motion.h"

namespace zona::coupling {

/// u(t) = amplitude sin(2 pi t / period) along the axis for t >= 0: the vibration of 5.3. Without a
/// ramp the velocity jumps to 2 pi amplitude / period at t = 0.
struct SineMotion {
  double amplitude;                                 ///< [m]
  double period;                                    ///< [s]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of any length except zero
  double ramp = 0;                                  ///< duration of the smooth start [s]
};

/// Rises linearly to the peak at duration / 2, falls linearly to zero at the duration and then
/// rests: the pulse of 5.3 and 5.5. The velocity jumps at these instants and has its new value
/// there.
struct TrianglePulse {
  double peak;                                      ///< [m]
  double duration;                                  ///< [s]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of any length except zero
  double ramp = 0;                                  ///< duration of the smooth start [s]
};

/// @{
/// Motion of a rigid body as a function of time.
///
/// The ramp (see `smooth_ramp`) multiplies the displacement; the velocity is the exact derivative
/// of the product. Throws `std::invalid_argument` if a parameter is not finite, a period or
/// duration is not positive, a ramp is negative, or an axis is zero. The motion throws
/// `std::out_of_range` before t = 0.
mpm::RigidMotion rigid_motion(const SineMotion& sine);
mpm::RigidMotion rigid_motion(const TrianglePulse& pulse);
/// @}

/// The axis as a unit vector. Throws `std::invalid_argument` if it has no direction.
Eigen::Vector3d unit_axis(const Eigen::Vector3d& axis);

}  // namespace zona::coupling
