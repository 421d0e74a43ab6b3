#pragma once

#include <Eigen/Core>

#include "beam/hydrodynamics.h"

namespace zona::beam {

/// Rates p_0 < p_1 < ... of Maxwell elements, evenly spaced in their logarithm: functions of the
/// form int w(ln p) s/(s + p) d(ln p) become sums over them by the trapezoidal rule, whose error on
/// the imaginary axis is exp(-pi^2 / spacing). All weights are positive, so that what stands for a
/// passive load is passive.
struct RateLadder {
  Eigen::ArrayXd rate;  ///< [1/s]
  double spacing = 1;   ///< of ln p

  /// Rates that serve angular frequencies from `lowest` to `highest` [rad/s]: from a thousandth of
  /// the one to a hundred times the other. Throws std::invalid_argument unless 0 < lowest <
  /// highest.
  static RateLadder over(double lowest, double highest, double spacing = 1);
};

/// A function of the Laplace variable s: instant + slope s + sum_j weight_j s / (s + rate_j).
struct Relaxation {
  double instant = 0;     ///< what the elements slower than the ladder come to
  double slope = 0;       ///< what the faster ones come to [s]
  Eigen::ArrayXd weight;  ///< one per rate
};

/// `viscous_ratio` of a cylinder of this radius [m] in s. Its weights follow from the jump of
/// K1/K0 across the negative axis: lambda K1(lambda)/K0(lambda) = int s/(s + p) w d(ln p) with
/// w = 2 / (pi^2 (J0^2(x) + Y0^2(x))), x = a sqrt(p rho/eta).
Relaxation viscous_relaxation(const RateLadder& ladder, const Liquid& liquid, double radius);

/// Stiffness with the same loss factor tan(delta) at all frequencies, relative to the storage
/// modulus at `reference` [rad/s]: (s/reference)^a / cos(a pi/2) with a = 2/pi atan(loss factor)
/// (Kjartansson, J. Geophys. Res. 84, 4737, 1979); s^a = sin(a pi)/pi int p^a s/(s + p) d(ln p).
Relaxation loss_relaxation(const RateLadder& ladder, double loss_factor, double reference);

/// The same in closed form.
std::complex<double> loss_modulus(std::complex<double> s, double loss_factor, double reference);

/// The value of a relaxation at s.
std::complex<double> evaluate(const RateLadder& ladder, const Relaxation& relaxation,
                              std::complex<double> s);

}  // namespace zona::beam
