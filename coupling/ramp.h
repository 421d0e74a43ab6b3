#pragma once

namespace zona::coupling {

/// A factor of a displacement and its derivative.
struct Ramp {
  double value;  ///< [-]
  double slope;  ///< [1/s]
};

/// Smooth start: s^2 (3 - 2 s) with s = time / duration rises from 0 to 1 with zero slope at both
/// ends and stays 1. A duration of zero means no ramp. Times in [s]; `time` must not be negative.
inline Ramp smooth_ramp(double time, double duration) {
  if (time >= duration) return {1, 0};
  const double s = time / duration;
  return {s * s * (3 - 2 * s), 6 * s * (1 - s) / duration};
}

}  // namespace zona::coupling
