#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "beam/motion/sampling.h"
#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"

namespace zona::beam {

/// Time [s] from the end of a pulse, `pulse_end` [s], to the first sample after which the
/// displacement stays within a tenth of its peak; 0 if that is before the end of the pulse,
/// infinite if it does not happen within the history. The history must not be empty.
double ring_down(const TipHistory& history, double pulse_end);

/// Greatest magnitude of the displacement in the last tenth of the samples [m].
double residual_amplitude(const TipHistory& history);

/// A kink of a support motion and its derivative with respect to a parameter p.
struct KinkDerivative {
  Kink kink;  ///< time [s] and jump of the velocity [m/s]
  Kink rate;  ///< their derivatives [s per unit of p], [m/s per unit of p]
};

/// Derivatives of the kinks of a support motion with respect to a parameter, in the order of time.
/// `moved` are the motions with the parameter at the `stencil_places` times `step`. Empty if the
/// number of kinks changes with the parameter.
std::vector<KinkDerivative> kink_derivatives(const SupportMotion& motion,
                                             const std::array<SupportMotion, 4>& moved,
                                             double step);

/// True if a parameter of the given value changes any of the kinks by more than rounding.
bool has_effect(const std::vector<KinkDerivative>& kinks, double value);

/// Derivative of the Laplace transform sum_k J_k exp(-s t_k) / s^2 of a support motion of straight
/// pieces, at each s [m s per unit of the parameter].
std::vector<std::complex<double>> laplace_transform_derivative(
    const std::vector<KinkDerivative>& kinks, const std::vector<std::complex<double>>& s);

/// Derivatives of a TipResponse with respect to a parameter p.
struct TipResponseDerivative {
  double amplitude = 0;             ///< [m per unit of p]
  double peak_velocity = 0;         ///< [m/s per unit of p]
  std::optional<double> ring_down;  ///< [s per unit of p]; absent if the response has none
};

/// Peaks and ring-down of a tip's response to a pulse, from its Laplace transform. Unlike the
/// values of a sampled history they are found between the samples, so that they are differentiable:
/// peaks on the cubic through values and slopes, ring-down by linear interpolation.
class TipResponse {
 public:
  /// `transform` is the transform of the tip's displacement [m s] at the `transform_points` of the
  /// sampling, `pulse_end` [s] the end of the pulse. Throws std::invalid_argument if the transform
  /// has another number of values.
  TipResponse(const std::vector<std::complex<double>>& transform, const Sampling& sampling,
              double pulse_end);

  double amplitude() const;      ///< greatest magnitude of the displacement [m]
  double peak_velocity() const;  ///< greatest magnitude of the velocity [m/s]
  /// Time [s] from the end of the pulse until the displacement stays within a tenth of the
  /// amplitude; absent if that does not happen within the samples.
  std::optional<double> ring_down() const;

  /// Derivatives with respect to a parameter, from the derivative of the transform at the
  /// `transform_points` and that of the pulse's end [s per unit of the parameter]. A response is
  /// stationary at its peaks, so their shift in time has no effect on their values.
  TipResponseDerivative derivative(const std::vector<std::complex<double>>& transform_derivative,
                                   double pulse_end_rate) const;

 private:
  /// An instant between two samples.
  struct Instant {
    std::size_t sample = 0;  ///< the sample before
    double share = 0;        ///< of the interval after it
  };

  static Instant peak_instant(const std::vector<double>& values, const std::vector<double>& slope);
  static std::optional<Instant> last_crossing(const std::vector<double>& values, double limit);
  static double linear_value(const Instant& at, const std::vector<double>& values);
  double cubic_value(const Instant& at, const std::vector<double>& values,
                     const std::vector<double>& slope) const;

  Sampling sampling_;
  double pulse_end_;
  std::vector<double> displacement_, velocity_;
  Instant displacement_peak_, velocity_peak_;
  double amplitude_, peak_velocity_;  ///< with their signs
  std::optional<Instant> crossing_;
};

}  // namespace zona::beam
