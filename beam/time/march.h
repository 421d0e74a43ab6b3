#pragma once

#include <vector>

#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"
#include "beam/time/integrate.h"

namespace zona::beam {

/// Motion of the observed point relative to the support.
struct RelativeMotion {
  double displacement = 0;  ///< [m]
  double velocity = 0;      ///< [m/s]
  double acceleration = 0;  ///< [m/s^2]
};

/// Appends a sample: relative motion plus the rigid motion with the support (5.73), (5.75).
inline void record(TipHistory& history, const SupportMotion& motion, double support_share,
                   double time, const RelativeMotion& relative) {
  const double support = displacement(motion, time);
  history.time.push_back(time);
  history.displacement.push_back(relative.displacement + support_share * support);
  history.velocity.push_back(relative.velocity + support_share * velocity(motion, time));
  history.acceleration.push_back(relative.acceleration +
                                 support_share * smooth_acceleration(motion, time));
  history.support.push_back(support);
}

/// Advances a stepper over the samples, from rest, and stops at every kink of the support motion,
/// so that no step contains a kink. The stepper has
///     void advance(double from, double to)   over a span in which g'' is smooth,
///     void kick(double time, double jump)    relative velocity changes by -M^-1 m jump,
///     RelativeMotion observed() const        at the current time.
/// A kink within 1e-9 sampling steps of a sample is moved onto it.
template <class Stepper>
TipHistory march(double support_share, const SupportMotion& motion, const Sampling& sampling,
                 Stepper& stepper) {
  const std::vector<Kink> all_kinks = kinks(motion);
  auto kink = all_kinks.begin();
  const double snap = 1e-9 * sampling.step;
  TipHistory history;
  double time = 0;
  for (int sample = 0; sample < sample_count(sampling); ++sample) {
    const double target = sample * sampling.step;
    for (; kink != all_kinks.end() && kink->time <= target + snap; ++kink) {
      const double stop = kink->time > target - snap ? target : kink->time;
      if (stop > time) stepper.advance(time, stop);
      stepper.kick(stop, kink->velocity_jump);
      time = stop;
    }
    if (target > time) stepper.advance(time, target);
    time = target;
    record(history, motion, support_share, time, stepper.observed());
  }
  return history;
}

}  // namespace zona::beam
