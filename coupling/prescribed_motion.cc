#include "coupling/prescribed_motion.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "coupling/ramp.h"

namespace zona::coupling {

namespace {

/// Motion along an axis.
struct AxialState {
  double displacement;  ///< [m]
  double velocity;      ///< [m/s]
};

void check(const char* motion, const char* length_name, double length, const char* time_name,
           double time, double ramp) {
  if (!std::isfinite(length))
    throw std::invalid_argument(
        fmt::format("{}: {} {} m is not finite", motion, length_name, length));
  if (!(time > 0) || !std::isfinite(time))
    throw std::invalid_argument(
        fmt::format("{}: {} {} s must be positive", motion, time_name, time));
  if (!(ramp >= 0) || !std::isfinite(ramp))
    throw std::invalid_argument(fmt::format("{}: ramp {} s must not be negative", motion, ramp));
}

/// Motion along `axis` that path(time) gives as AxialState, with the ramp applied.
template <class Path>
mpm::RigidMotion along(const Eigen::Vector3d& axis, double ramp_duration, Path path) {
  return [axis = unit_axis(axis), ramp_duration, path](double time) {
    if (!(time >= 0))
      throw std::out_of_range(
          fmt::format("a prescribed motion starts at 0 s and cannot be evaluated at {} s", time));
    const AxialState plain = path(time);
    const Ramp ramp = smooth_ramp(time, ramp_duration);
    return mpm::RigidState{ramp.value * plain.displacement * axis,
                           (ramp.slope * plain.displacement + ramp.value * plain.velocity) * axis};
  };
}

}  // namespace

Eigen::Vector3d unit_axis(const Eigen::Vector3d& axis) {
  const double length = axis.norm();
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument(fmt::format("the axis ({}, {}, {}) of a motion has no direction",
                                            axis.x(), axis.y(), axis.z()));
  return axis / length;
}

mpm::RigidMotion rigid_motion(const SineMotion& sine) {
  check("sine", "amplitude", sine.amplitude, "period", sine.period, sine.ramp);
  const double frequency = 2 * M_PI / sine.period;
  return along(sine.axis, sine.ramp, [amplitude = sine.amplitude, frequency](double time) {
    return AxialState{amplitude * std::sin(frequency * time),
                      amplitude * frequency * std::cos(frequency * time)};
  });
}

mpm::RigidMotion rigid_motion(const TrianglePulse& pulse) {
  check("triangle", "peak", pulse.peak, "duration", pulse.duration, pulse.ramp);
  const double half = pulse.duration / 2;
  return along(pulse.axis, pulse.ramp,
               [peak = pulse.peak, half, end = pulse.duration](double time) -> AxialState {
                 const double speed = peak / half;
                 if (time < half) return {speed * time, speed};
                 if (time < end) return {speed * (end - time), -speed};
                 return {0, 0};
               });
}

}  // namespace zona::coupling
