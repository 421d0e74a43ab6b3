#pragma once

namespace zona::coupling {

/// A sample of a function of time, and of its derivative.
struct Sample {
  double time;   ///< [s]
  double value;  ///< [m]
  double slope;  ///< [m/s]
};

/// Value and slope at `time` of the cubic through two samples with their slopes, exact at both
/// ends.
inline Sample hermite_cubic(const Sample& left, const Sample& right, double time) {
  const double step = right.time - left.time;
  const double s = (time - left.time) / step;
  const double r = (right.time - time) / step;
  const double secant = (right.value - left.value) / step;
  // Linear interpolation plus what the slopes add to it.
  const double left_excess = left.slope - secant;
  const double right_excess = right.slope - secant;
  return {time,
          r * left.value + s * right.value + step * s * r * (r * left_excess - s * right_excess),
          secant + r * (r - 2 * s) * left_excess + s * (s - 2 * r) * right_excess};
}

}  // namespace zona::coupling
