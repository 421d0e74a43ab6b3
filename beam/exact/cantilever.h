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
/// Nothing here is shared with the finite elements: it is what they are checked against.
class ExactCantilever {
 public:
  /// Throws std::invalid_argument unless the beam's length, rigidity and mass are positive and
  /// 1 <= modes <= 100000.
  ExactCantilever(const UniformBeam& beam, int modes);

  int modes() const { return static_cast<int>(root_.size()); }  ///< how many the sums take

  /// alpha_n L: the n-th positive root of cosh z cos z = -1 (5.70). Modes count from 1.
  double root(int mode) const { return root_.at(mode - 1); }

  /// omega_n (5.72) [rad/s].
  double angular_frequency(int mode) const;

  /// V_n(x) of (5.69), scaled so that its mean square over the length is 1; V_n(L) = 2 (-1)^(n+1).
  /// Written so that no term exceeds 2 in magnitude however high the mode.
  double shape(int mode, double x) const;

  /// Mean of V_n over the length times V_n(L): the share of mode n in the tip's rigid motion, which
  /// sums to 1 over all modes.
  double tip_share(int mode) const;

  /// Tip relative to the support at one time: minus the sum over modes of tip_share times the
  /// impulse responses to the kinks of g. Exact in time; the error of the displacement is the modes
  /// left out, which falls as 1/modes^2. Velocities lack the modes left out, the more so right
  /// after a kink; accelerations are those of the modes kept and do not converge with more of them.
  RelativeMotion tip_relative(const std::vector<Kink>& kinks, double time,
                              const RayleighDamping& damping = {}) const;

  /// Absolute motion of the tip at the samples of an integrator: the same sum, its oscillators
  /// turned from sample to sample, which makes thousands of modes affordable.
  TipHistory tip_history(const SupportMotion& motion, const Sampling& sampling,
                         const RayleighDamping& damping = {}) const;

 private:
  UniformBeam beam_;
  std::vector<double> root_;
};

}  // namespace zona::beam
