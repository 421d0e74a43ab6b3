#include "beam/pipette/hydrodynamics.h"

#include <cmath>

namespace zona::beam {
namespace {

using Complex = std::complex<double>;

/// K1(z) / K0(z) for |arg z| <= pi/4.
Complex bessel_quotient(Complex z) {
  // The integrand is analytic for |Im t| < pi/4. The error is exp(-pi^2 / (2 step)) for small z,
  // and exp(-sqrt(2) pi^2 / (step^2 |z|)) for large z, where the integrand has the width 1/sqrt(z).
  const double step = 0.16 / std::sqrt(1 + 0.056 * std::abs(z));
  constexpr double negligible = 40;  // exponent of negligible terms, exp(-40)
  Complex k0 = 0.5, k1 = 0.5;        // both scaled by exp(z)
  for (int i = 1;; ++i) {
    const double t = i * step;
    const double rise = std::cosh(t) - 1;
    if (rise * z.real() > negligible + t) break;
    const Complex value = std::exp(-z * rise);
    k0 += value;
    k1 += value * (rise + 1);
  }
  return k1 / k0;
}

}  // namespace

Complex outer_ratio(Complex lambda) {
  return lambda * bessel_quotient(lambda);
}

Complex bore_ratio(Complex lambda) {
  const double size = std::abs(lambda);
  if (size > 60) {
    const Complex y = 1. / lambda;
    return lambda - 0.5 -
           y * (1 / 8. + y * (1 / 8. + y * (25 / 128. + y * (13 / 32. + y * (1073 / 1024.)))));
  }
  // lambda^2/(2 + lambda^2/(4 + lambda^2/(6 + ...))) needs about |lambda| terms.
  const Complex square = lambda * lambda;
  const int terms = 20 + static_cast<int>(size);
  Complex rest = 2. * terms;
  for (int n = terms - 1; n >= 1; --n) rest = 2. * n + square / rest;
  return square / rest;
}

Complex viscous_load(Flow flow, const Liquid& liquid, double radius, Complex s) {
  const Complex lambda = radius * std::sqrt(s * liquid.density / liquid.viscosity);
  const Complex ratio = flow == Flow::within ? bore_ratio(lambda) : outer_ratio(lambda);
  return (flow == Flow::across ? 4 : 2) * M_PI * liquid.viscosity * ratio;
}

}  // namespace zona::beam
