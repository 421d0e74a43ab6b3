#include "studies/references/hencky_membrane.h"

#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

// Terms fall like (1/b_0^3)^n ~ 0.2^n; the last one is far below rounding.
constexpr int terms = 60;

struct Series {
  std::vector<double> b, reciprocal;
};

/// Coefficients of B and 1/B for b_0 = 1. For another b_0 they are b_n b_0^(1 - 3n) and
/// c_n b_0^(-1 - 3n).
Series unit_series() {
  std::vector<double> b{1}, c{1};
  for (int n = 1; n <= terms; ++n) {
    double square = 0;  // [1/B^2]_{n-1}
    for (int i = 0; i < n; ++i) square += c[i] * c[n - 1 - i];
    b.push_back(-2 * square / (n * (n + 1.0)));
    double product = 0;  // B (1/B) = 1
    for (int i = 1; i <= n; ++i) product += b[i] * c[n - i];
    c.push_back(-product);
  }
  return {b, c};
}

/// The b_0 at which the edge does not move.
double first_coefficient(const std::vector<double>& b, double nu) {
  const auto edge = [&](double b0) {
    double sum = 0;
    for (int n = 0; n <= terms; ++n) sum += b[n] * std::pow(b0, -3.0 * n) * (1 - nu + 2 * n);
    return sum;
  };
  double low = 1.5, high = 3;  // from nu = -0.1 to beyond 0.5; edge() rises with b_0
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (edge(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

HenckyMembrane::HenckyMembrane(const PressurisedDisc& disc) : disc_(disc) {
  require_positive(disc.radius, "radius");
  require_positive(disc.thickness, "thickness");
  require_positive(disc.youngs_modulus, "Young's modulus");
  require_positive(disc.pressure, "pressure");
  require(disc.poisson_ratio >= 0 && disc.poisson_ratio <= 0.5,
          "Poisson's ratio must be in [0, 0.5], not " + std::to_string(disc.poisson_ratio));
  const Series unit = unit_series();
  const double b0 = references::first_coefficient(unit.b, disc.poisson_ratio);
  for (int n = 0; n <= terms; ++n) {
    b_.push_back(unit.b[n] * std::pow(b0, 1 - 3.0 * n));
    reciprocal_.push_back(unit.reciprocal[n] * std::pow(b0, -1 - 3.0 * n));
  }
}

double HenckyMembrane::series(double x) const {
  double sum = 0;
  for (int n = terms; n >= 0; --n) sum = sum * x + b_[n];
  return sum;
}

double HenckyMembrane::deflection(double r) const {
  const double x = std::pow(r / disc_.radius, 2);
  double sum = 0;  // the integral of 1/B from X to 1
  for (int n = terms; n >= 0; --n) sum += reciprocal_[n] * (1 - std::pow(x, n + 1)) / (n + 1);
  return disc_.radius * std::cbrt(disc_.load()) * sum;
}

double HenckyMembrane::slope(double r) const {
  const double rho = r / disc_.radius;
  return -2 * std::cbrt(disc_.load()) * rho / series(rho * rho);
}

double HenckyMembrane::radial_tension(double r) const {
  const double k = std::cbrt(disc_.load()), x = std::pow(r / disc_.radius, 2);
  return 0.25 * disc_.youngs_modulus * disc_.thickness * k * k * series(x);
}

double HenckyMembrane::hoop_tension(double r) const {
  const double k = std::cbrt(disc_.load()), x = std::pow(r / disc_.radius, 2);
  double sum = 0;
  for (int n = terms; n >= 0; --n) sum = sum * x + (1 + 2 * n) * b_[n];
  return 0.25 * disc_.youngs_modulus * disc_.thickness * k * k * sum;
}

}  // namespace zona::studies::references
