#pragma once

#include <Eigen/Core>

#include "beam/pipette/hydrodynamics.h"

namespace zona::beam {

/// Rates p_0 < p_1 < ... of Maxwell elements, evenly spaced in their logarithm: functions of the
/// form int w(ln p) s/(s + p) d(ln p) become sums over them by the trapezoidal rule, whose error on
/// the imaginary axis is exp(-pi^2 / spacing).
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

/// `viscous_load` of a cylinder or a bore of this radius [m] in s, its weights in [Pa s].
/// Around a cylinder they follow from the jump of K1/K0 across the negative axis, lambda
/// K1(lambda)/K0(lambda) = int s/(s + p) w d(ln p) with w = 2 / (pi^2 (J0^2(x) + Y0^2(x))), x = a
/// sqrt(p rho/eta); all are positive. Within a bore lambda I1(lambda)/I0(lambda) = 2 sum_n s/(s +
/// p_n) has poles, p_n = j_n^2 eta/(rho a^2) with the zeros j_n of J0; each is shared by the four
/// rates next to it as the cubic in ln p through them has it. With a spacing of 0.5 that errs by
/// some 1e-3.
Relaxation viscous_relaxation(Flow flow, const RateLadder& ladder, const Liquid& liquid,
                              double radius);

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
