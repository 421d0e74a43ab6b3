#include "beam/pipette/hydrodynamics.h"

#include <cmath>

namespace zona::beam {
namespace {

using Complex = std::complex<double>;

constexpr double kPi = 3.14159265358979323846;

/// K1(z) / K0(z) for |arg z| <= pi/4.
Complex bessel_quotient(Complex z) {
  // The integrand is analytic for |Im t| < pi/4: the error is exp(-pi^2 / (2 step)) while z is
  // small, and exp(-sqrt(2) pi^2 / (step^2 |z|)) where the integrand is as narrow as 1/sqrt(z).
  const double step = 0.16 / std::sqrt(1 + 0.056 * std::abs(z));
  constexpr double negligible = 40;  // exp(-40)
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
  // lambda^2/(2 + lambda^2/(4 + lambda^2/(6 + ...))), whose terms matter up to about |lambda|.
  const Complex square = lambda * lambda;
  const int terms = 20 + static_cast<int>(size);
  Complex rest = 2. * terms;
  for (int n = terms - 1; n >= 1; --n) rest = 2. * n + square / rest;
  return square / rest;
}

Complex hydrodynamic_function(double reynolds_number) {
  // s = -i omega, so that lambda^2 = -i Re.
  const Complex lambda = std::sqrt(Complex(0, -reynolds_number));
  return 1. + 4. * outer_ratio(lambda) / (lambda * lambda);
}

CylinderLoad cylinder_load(const Liquid& liquid, double radius, double angular_frequency) {
  const double area = kPi * radius * radius;
  const Complex gamma = hydrodynamic_function(liquid.density * angular_frequency * radius * radius /
                                              liquid.viscosity);
  return {liquid.density * area * gamma.real(),
          liquid.density * area * angular_frequency * gamma.imag()};
}

Complex viscous_load(Flow flow, const Liquid& liquid, double radius, Complex s) {
  const Complex lambda = radius * std::sqrt(s * liquid.density / liquid.viscosity);
  const Complex ratio = flow == Flow::within ? bore_ratio(lambda) : outer_ratio(lambda);
  return (flow == Flow::across ? 4 : 2) * kPi * liquid.viscosity * ratio;
}

}  // namespace zona::beam
