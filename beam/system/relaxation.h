#pragma once

#include <Eigen/Core>

#include "beam/pipette/hydrodynamics.h"

namespace zona::beam {

/// Rates p_0 < p_1 < ... of Maxwell elements, evenly spaced in their logarithm. The trapezoidal
/// rule turns functions of the form int w(ln p) s/(s + p) d(ln p) into sums over the rates, with an
/// error of exp(-pi^2 / spacing) on the imaginary axis.
struct RateLadder {
  Eigen::ArrayXd rate;  ///< [1/s]
  double spacing = 1;   ///< of ln p

  /// Rates for angular frequencies from `lowest` to `highest` [rad/s], from lowest / 1000 to
  /// 100 highest. Throws std::invalid_argument unless 0 < lowest < highest and the spacing is
  /// positive.
  static RateLadder over(double lowest, double highest, double spacing = 1);
};

/// A function of the Laplace variable s: instant + slope s + sum_j weight_j s / (s + rate_j).
struct Relaxation {
  double instant = 0;     ///< sum of the elements slower than the ladder
  double slope = 0;       ///< sum of the elements faster than the ladder [s]
  Eigen::ArrayXd weight;  ///< one per rate
};

/// `viscous_load` around a cylinder or in a bore of this radius [m], with weights in [Pa s].
///
/// Around a cylinder the weights follow from the jump of K1/K0 across the negative axis:
/// lambda K1(lambda)/K0(lambda) = int s/(s + p) w d(ln p) with w = 2 / (pi^2 (J0^2(x) + Y0^2(x))),
/// x = a sqrt(p rho/eta); all are positive. In a bore lambda I1(lambda)/I0(lambda) =
/// 2 sum_n s/(s + p_n) has the poles p_n = j_n^2 eta/(rho a^2) with the zeros j_n of J0. Each pole
/// is distributed to its four nearest rates by cubic interpolation in ln p; with a spacing of 0.5
/// the error is about 1e-3.
Relaxation viscous_relaxation(Flow flow, const RateLadder& ladder, const Liquid& liquid,
                              double radius);

/// Modulus with the same loss factor tan(delta) at all frequencies, relative to the storage modulus
/// at `reference` [rad/s]: (s/reference)^a / cos(a pi/2) with a = 2/pi atan(loss factor)
/// (Kjartansson, J. Geophys. Res. 84, 4737, 1979). s^a = sin(a pi)/pi int p^a s/(s + p) d(ln p)
/// gives the weights.
Relaxation loss_relaxation(const RateLadder& ladder, double loss_factor, double reference);

/// The same modulus in closed form, at s [1/s].
std::complex<double> loss_modulus(std::complex<double> s, double loss_factor, double reference);

/// Value of a relaxation at s [1/s].
std::complex<double> evaluate(const RateLadder& ladder, const Relaxation& relaxation,
                              std::complex<double> s);

}  // namespace zona::beam
