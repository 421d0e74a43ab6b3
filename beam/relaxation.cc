#include "beam/relaxation.h"

#include <fmt/format.h>

#include <cmath>

#include "beam/require.h"

namespace zona::beam {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// 2 / (pi^2 (J0^2 + Y0^2)) at x = exp(u/2).
double viscous_weight(double u) {
  constexpr double large =
      7.8;  // x = 50: the next term of the series is 1e-6 of the last one taken
  if (u > large) {
    const double y = std::exp(-u);  // 1/x^2; J0^2 + Y0^2 = 2/(pi x) (1 - y/8 + 27 y^2/128 - ...)
    return std::exp(u / 2) / (kPi * (1 - y / 8 + 27 * y * y / 128));
  }
  const double x = std::exp(u / 2);
  const double j = std::cyl_bessel_j(0, x);
  const double y = std::cyl_neumann(0, x);
  return 2 / (kPi * kPi * (j * j + y * y));
}

/// Sum of spacing * viscous_weight at u - spacing, u - 2 spacing, ... without end.
double slower_weights(double u, double spacing) {
  // For x < 5e-5 the weight is 2 / (pi^2 + (u - c)^2) to 1e-8; then Euler-Maclaurin.
  constexpr double small = -20;
  constexpr double c = 2 * 0.69314718055994531 - 2 * 0.57721566490153286;
  double sum = 0;
  for (u -= spacing; u > small; u -= spacing) sum += spacing * viscous_weight(u);
  const double distance = u - c;
  const double nearest = kPi * kPi + distance * distance;
  return sum + 2 / kPi * (kPi / 2 + std::atan(distance / kPi)) + spacing / nearest -
         spacing * spacing / 12 * 4 * distance / (nearest * nearest);
}

/// Sum of spacing * viscous_weight * exp(-ln p) relative to p at u + spacing, u + 2 spacing, ...
double faster_weights(double u, double spacing) {
  double sum = 0;
  for (int i = 1;; ++i) {
    const double term = spacing * viscous_weight(u + i * spacing) * std::exp(-i * spacing);
    sum += term;
    if (term < 1e-17 * sum) return sum;
  }
}

}  // namespace

RateLadder RateLadder::over(double lowest, double highest, double spacing) {
  require(is_positive(lowest) && highest > lowest && is_positive(spacing),
          fmt::format("relaxation rates: frequencies from {} to {} rad/s at spacing {}, but they "
                      "must be above 0 and increase",
                      lowest, highest, spacing));
  // What lies below acts as a constant to first order in p/omega, what lies above to order 3/2.
  constexpr double below = 1000, above = 100;
  const double first = std::log(lowest / below);
  const auto count =
      static_cast<Eigen::Index>(std::ceil((std::log(highest * above) - first) / spacing)) + 1;
  RateLadder ladder;
  ladder.spacing = spacing;
  ladder.rate = (first + spacing * Eigen::ArrayXd::LinSpaced(count, 0, double(count - 1))).exp();
  return ladder;
}

Relaxation viscous_relaxation(const RateLadder& ladder, const Liquid& liquid, double radius) {
  const double scale = std::log(radius * radius * liquid.density / liquid.viscosity);
  const Eigen::Index last = ladder.rate.size() - 1;
  Relaxation relaxation;
  relaxation.weight.resize(last + 1);
  for (Eigen::Index j = 0; j <= last; ++j)
    relaxation.weight(j) = ladder.spacing * viscous_weight(std::log(ladder.rate(j)) + scale);
  relaxation.instant = slower_weights(std::log(ladder.rate(0)) + scale, ladder.spacing);
  relaxation.slope =
      faster_weights(std::log(ladder.rate(last)) + scale, ladder.spacing) / ladder.rate(last);
  return relaxation;
}

Relaxation loss_relaxation(const RateLadder& ladder, double loss_factor, double reference) {
  const double a = 2 / kPi * std::atan(loss_factor);
  const double h = ladder.spacing;
  const double scale = h * std::sin(a * kPi) / (kPi * std::cos(a * kPi / 2));
  Relaxation relaxation;
  relaxation.weight = scale * (ladder.rate / reference).pow(a);
  const Eigen::Index last = ladder.rate.size() - 1;
  // Geometric series below and above the ladder.
  relaxation.instant = relaxation.weight(0) / std::expm1(a * h);
  relaxation.slope = relaxation.weight(last) / std::expm1((1 - a) * h) / ladder.rate(last);
  return relaxation;
}

std::complex<double> loss_modulus(std::complex<double> s, double loss_factor, double reference) {
  const double a = 2 / kPi * std::atan(loss_factor);
  return std::pow(s / reference, a) / std::cos(a * kPi / 2);
}

std::complex<double> evaluate(const RateLadder& ladder, const Relaxation& relaxation,
                              std::complex<double> s) {
  return relaxation.instant + relaxation.slope * s +
         (relaxation.weight * s / (s + ladder.rate)).sum();
}

}  // namespace zona::beam
