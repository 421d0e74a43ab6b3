#pragma once

#include <vector>

#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"
#include "beam/pipette/section.h"
#include "beam/time/integrate.h"
#include "beam/time/march.h"

namespace zona::beam {

/// Rayleigh damping of the relative motion: every mode decays at (alpha + beta omega^2) / 2.
struct RayleighDamping {
  double alpha = 0;  ///< [1/s]
  double beta = 0;   ///< [s]
};

/// Uniform Euler-Bernoulli cantilever on a moving support, by its analytic modes (5.58)-(5.72).
/// Shares nothing with the finite elements, which are verified against it.
class ExactCantilever {
 public:
  /// Throws std::invalid_argument unless the beam's length, rigidity and mass are positive and
  /// 1 <= modes <= 100000.
  ExactCantilever(const UniformBeam& beam, int modes);

  int modes() const { return static_cast<int>(root_.size()); }  ///< number of modes in the sums

  /// alpha_n L, the n-th positive root of cosh z cos z = -1 (5.70). Modes count from 1.
  double root(int mode) const { return root_.at(mode - 1); }

  /// omega_n (5.72) [rad/s].
  double angular_frequency(int mode) const;

  /// V_n(x) of (5.69), scaled to a mean square of 1 over the length; V_n(L) = 2 (-1)^(n+1). Written
  /// so that no term exceeds 2 in magnitude, for any mode.
  double shape(int mode, double x) const;

  /// Mean of V_n over the length times V_n(L): share of mode n in the rigid motion of the tip. Sums
  /// to 1 over all modes.
  double tip_share(int mode) const;

  /// Motion of the tip relative to the support at one time [s]: minus the sum over modes of
  /// tip_share times the impulse responses to the kinks of g. Exact in time. Truncating the modes
  /// causes an error in the displacement that falls as 1/modes^2, and a larger one in the velocity,
  /// especially right after a kink; accelerations do not converge with the number of modes.
  RelativeMotion tip_relative(const std::vector<Kink>& kinks, double time,
                              const RayleighDamping& damping = {}) const;

  /// Absolute motion of the tip at all samples: the same sum, with the oscillators advanced from
  /// sample to sample, which makes thousands of modes affordable.
  TipHistory tip_history(const SupportMotion& motion, const Sampling& sampling,
                         const RayleighDamping& damping = {}) const;

 private:
  UniformBeam beam_;
  std::vector<double> root_;
};

}  // namespace zona::beam
