#include "beam/system/relaxation.h"

#include <fmt/format.h>

#include <cmath>

#include "beam/algebra/require.h"

namespace zona::beam {
namespace {

/// 2 / (pi^2 (J0^2 + Y0^2)) at x = exp(u/2).
double viscous_weight(double u) {
  constexpr double large =
      7.8;  // x = 50, where the next term of the series is 1e-6 of the last one
  if (u > large) {
    const double y = std::exp(-u);  // 1/x^2; J0^2 + Y0^2 = 2/(pi x) (1 - y/8 + 27 y^2/128 - ...)
    return std::exp(u / 2) / (M_PI * (1 - y / 8 + 27 * y * y / 128));
  }
  const double x = std::exp(u / 2);
  const double j = std::cyl_bessel_j(0, x);
  const double y = std::cyl_neumann(0, x);
  return 2 / (M_PI * M_PI * (j * j + y * y));
}

/// Infinite sum of spacing * viscous_weight at u - spacing, u - 2 spacing, ...
double slower_weights(double u, double spacing) {
  // For x < 5e-5 the weight is 2 / (pi^2 + (u - c)^2) up to 1e-8; Euler-Maclaurin formula for
  // these.
  constexpr double small = -20;
  constexpr double c = 2 * 0.69314718055994531 - 2 * 0.57721566490153286;
  double sum = 0;
  for (u -= spacing; u > small; u -= spacing) sum += spacing * viscous_weight(u);
  const double distance = u - c;
  const double nearest = M_PI * M_PI + distance * distance;
  return sum + 2 / M_PI * (M_PI / 2 + std::atan(distance / M_PI)) + spacing / nearest -
         spacing * spacing / 12 * 4 * distance / (nearest * nearest);
}

/// Infinite sum of spacing * viscous_weight / p at u + spacing, u + 2 spacing, ..., where p is the
/// rate relative to that at u.
double faster_weights(double u, double spacing) {
  double sum = 0;
  for (int i = 1;; ++i) {
    const double term = spacing * viscous_weight(u + i * spacing) * std::exp(-i * spacing);
    sum += term;
    if (term < 1e-17 * sum) return sum;
  }
}

/// lambda K1/K0 around a cylinder.
Relaxation outer_relaxation(const RateLadder& ladder, double diffusion_time) {
  const double scale = std::log(diffusion_time);
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

/// n-th zero of the Bessel function J0, n >= 1: McMahon's series, with Newton steps for the first
/// ten zeros, where the series is inaccurate.
double zero_of_j0(int n) {
  const double beta = (n - 0.25) * M_PI;
  const double y = 1 / (8 * beta);
  double zero = beta + y - 124. / 3 * y * y * y + 120928. / 15 * std::pow(y, 5);
  if (n > 10) return zero;
  for (int step = 0; step < 3; ++step)
    zero += std::cyl_bessel_j(0, zero) / std::cyl_bessel_j(1, zero);
  return zero;
}

/// Lagrange cubics on -1, 0, 1 and 2, at t.
Eigen::Array4d cubic_shares(double t) {
  return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
          (t + 1) * t * (t - 1) / 6};
}

/// lambda I1/I0 in a bore.
Relaxation bore_relaxation(const RateLadder& ladder, double diffusion_time) {
  const Eigen::Index last = ladder.rate.size() - 1;
  Relaxation relaxation;
  relaxation.weight = Eigen::ArrayXd::Zero(last + 1);
  double missing = 0.25;  // sum of 1/j_n^2 over the remaining poles
  for (int n = 1;; ++n) {
    const double square = std::pow(zero_of_j0(n), 2);
    const double place = std::log(square / diffusion_time / ladder.rate(0)) / ladder.spacing;
    if (place >= static_cast<double>(last) - 1) break;
    missing -= 1 / square;
    if (place < 0) {
      relaxation.instant += 2;
      continue;
    }
    const auto first = std::max<Eigen::Index>(0, static_cast<Eigen::Index>(place) - 1);
    relaxation.weight.segment<4>(first) += 2 * cubic_shares(place - static_cast<double>(first) - 1);
  }
  relaxation.slope = 2 * diffusion_time * missing;
  return relaxation;
}

}  // namespace

RateLadder RateLadder::over(double lowest, double highest, double spacing) {
  require(is_positive(lowest) && highest > lowest && is_positive(spacing),
          fmt::format("relaxation rates: frequencies from {} to {} rad/s at spacing {}, but they "
                      "must be above 0 and increase",
                      lowest, highest, spacing));
  // Rates below act as a constant, to first order in p/omega; rates above as a slope, to order 3/2.
  constexpr double below = 1000, above = 100;
  const double first = std::log(lowest / below);
  const auto count =
      static_cast<Eigen::Index>(std::ceil((std::log(highest * above) - first) / spacing)) + 1;
  RateLadder ladder;
  ladder.spacing = spacing;
  ladder.rate = (first + spacing * Eigen::ArrayXd::LinSpaced(count, 0, double(count - 1))).exp();
  return ladder;
}

Relaxation viscous_relaxation(Flow flow, const RateLadder& ladder, const Liquid& liquid,
                              double radius) {
  const double diffusion_time = radius * radius * liquid.density / liquid.viscosity;
  Relaxation relaxation = flow == Flow::within ? bore_relaxation(ladder, diffusion_time)
                                               : outer_relaxation(ladder, diffusion_time);
  const double scale = (flow == Flow::across ? 4 : 2) * M_PI * liquid.viscosity;
  relaxation.weight *= scale;
  relaxation.instant *= scale;
  relaxation.slope *= scale;
  return relaxation;
}

Relaxation loss_relaxation(const RateLadder& ladder, double loss_factor, double reference) {
  const double a = 2 / M_PI * std::atan(loss_factor);
  const double h = ladder.spacing;
  const double scale = h * std::sin(a * M_PI) / (M_PI * std::cos(a * M_PI / 2));
  Relaxation relaxation;
  relaxation.weight = scale * (ladder.rate / reference).pow(a);
  const Eigen::Index last = ladder.rate.size() - 1;
  // Geometric series for the rates below and above the ladder.
  relaxation.instant = relaxation.weight(0) / std::expm1(a * h);
  relaxation.slope = relaxation.weight(last) / std::expm1((1 - a) * h) / ladder.rate(last);
  return relaxation;
}

std::complex<double> loss_modulus(std::complex<double> s, double loss_factor, double reference) {
  const double a = 2 / M_PI * std::atan(loss_factor);
  return std::pow(s / reference, a) / std::cos(a * M_PI / 2);
}

std::complex<double> evaluate(const RateLadder& ladder, const Relaxation& relaxation,
                              std::complex<double> s) {
  return relaxation.instant + relaxation.slope * s +
         (relaxation.weight * s / (s + ladder.rate)).sum();
}

}  // namespace zona::beam
