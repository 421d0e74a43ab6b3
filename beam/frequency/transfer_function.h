#pragma once

#include <complex>
#include <vector>

#include "beam/motion/sampling.h"
#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"
#include "beam/system/beam_system.h"

namespace zona::beam {

/// Absolute motion of the observed point over that of the support, V(s)/g(s), in the Laplace
/// variable s; at s = i omega the response to a support that vibrates steadily. Liquids have their
/// load at every frequency, and the stiffness its loss factor: nothing is approximated but by the
/// elements and, where the radius changes, by the interpolation of ViscousLoad. Rayleigh damping
/// acts on the relative motion. A quadratic drag is no linear load and is refused.
class TransferFunction {
 public:
  /// Keeps a reference to the system. Throws std::invalid_argument for a quadratic drag and for
  /// BathModel::per_mode.
  explicit TransferFunction(const BeamSystem& system);

  /// V/g at s [rad/s].
  std::complex<double> operator()(std::complex<double> s) const;

  /// At many values, four at once.
  std::vector<std::complex<double>> at(const std::vector<std::complex<double>>& s) const;

 private:
  const BeamSystem& system_;
};

/// Laplace transform of the support's displacement at each s [m s].
std::vector<std::complex<double>> laplace_transform(const SupportMotion& motion,
                                                    const std::vector<std::complex<double>>& s);

/// Values of s for `invert_transform`: a line right of the imaginary axis.
std::vector<std::complex<double>> transform_points(const Sampling& sampling);

/// The real function of time with this Laplace transform, given at the `transform_points`, at the
/// samples: a discrete Fourier transform along the line, over twice the samples' time or more. What
/// comes after that time returns by exp(-16); frequencies above three eighths of the samples' fade
/// out.
std::vector<double> invert_transform(const Sampling& sampling,
                                     const std::vector<std::complex<double>>& transform);

/// Motion of the observed point at the samples for this motion of the support, from the values of
/// the transfer function at the `transform_points`. One beam's values serve all its pulses.
TipHistory history_by_transform(std::vector<std::complex<double>> transfer,
                                const SupportMotion& motion, const Sampling& sampling);

/// Motion of the observed point at the samples, by the inverse Laplace transform of
/// TransferFunction times that of the support's motion. The velocity and the acceleration have no
/// frequencies above half the samples', and less of those above three eighths.
TipHistory integrate_by_transform(const BeamSystem& system, const SupportMotion& motion,
                                  const Sampling& sampling);

}  // namespace zona::beam
