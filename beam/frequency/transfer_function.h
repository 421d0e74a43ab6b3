#pragma once

#include <array>
#include <complex>
#include <vector>

#include "beam/motion/sampling.h"
#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"
#include "beam/system/beam_system.h"

namespace zona::beam {

/// Absolute motion of the observed point over the motion of the support, V(s)/g(s), in the Laplace
/// variable s; at s = i omega the response to steady vibration. Liquid loads and the loss factor
/// are exact at every frequency: only the elements approximate, and the interpolation of
/// ViscousLoad where the radius changes. Rayleigh damping acts on the relative motion.
class TransferFunction {
 public:
  /// Keeps a reference to the system. Throws std::invalid_argument for a quadratic drag, which is
  /// not linear, and for BathModel::per_mode.
  explicit TransferFunction(const BeamSystem& system);

  /// V/g [-] at s [1/s].
  std::complex<double> operator()(std::complex<double> s) const;

  /// V/g [-] at each s [1/s], four at a time.
  std::vector<std::complex<double>> at(const std::vector<std::complex<double>>& s) const;

 private:
  const BeamSystem& system_;
};

/// Laplace transform of the support's displacement [m s] at each s [1/s].
std::vector<std::complex<double>> laplace_transform(const SupportMotion& motion,
                                                    const std::vector<std::complex<double>>& s);

/// Values of s [1/s] for `invert_transform`, on a line right of the imaginary axis.
std::vector<std::complex<double>> transform_points(const Sampling& sampling);

/// Samples of the real function of time whose Laplace transform is given at the `transform_points`:
/// a discrete Fourier transform along the line, over at least twice the time of the samples. Later
/// values alias with a factor of exp(-16); frequencies above three eighths of the sampling
/// frequency fade out. Throws std::invalid_argument for another number of values.
std::vector<double> invert_transform(const Sampling& sampling,
                                     const std::vector<std::complex<double>>& transform);

/// The function of `invert_transform` and its first two derivatives [1/s], [1/s^2] at the samples.
std::array<std::vector<double>, 3> invert_with_derivatives(
    const Sampling& sampling, std::vector<std::complex<double>> transform);

/// Motion of the observed point at the samples for this motion of the support, from the values of
/// the transfer function at the `transform_points`. The values of a beam serve all its pulses.
TipHistory history_by_transform(std::vector<std::complex<double>> transfer,
                                const SupportMotion& motion, const Sampling& sampling);

/// Motion of the observed point at the samples, by the inverse Laplace transform of
/// TransferFunction times the transform of the support's motion. Velocity and acceleration lack
/// frequencies above half the sampling frequency and have less of those above three eighths.
TipHistory integrate_by_transform(const BeamSystem& system, const SupportMotion& motion,
                                  const Sampling& sampling);

}  // namespace zona::beam
