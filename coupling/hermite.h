#pragma once

namespace zona::coupling {

/// Value and slope of a function at a time.
struct HermitePoint {
  double time;   ///< [s]
  double value;  ///< [m]
  double slope;  ///< [m/s]
};

/// Value and slope at `time` [s] of the cubic through the values and slopes of two points; exact at
/// both.
inline HermitePoint hermite_cubic(const HermitePoint& left, const HermitePoint& right,
                                  double time) {
  const double step = right.time - left.time;
  const double s = (time - left.time) / step;
  const double r = (right.time - time) / step;
  const double secant = (right.value - left.value) / step;
  // Linear interpolation plus a correction by the slopes.
  const double left_excess = left.slope - secant;
  const double right_excess = right.slope - secant;
  return {time,
          r * left.value + s * right.value + step * s * r * (r * left_excess - s * right_excess),
          secant + r * (r - 2 * s) * left_excess + s * (s - 2 * r) * right_excess};
}

}  // namespace zona::coupling
