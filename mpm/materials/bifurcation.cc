#include "mpm/materials/bifurcation.h"

#include <algorithm>
#include <cmath>

namespace zona::mpm {

namespace {

/// Contact of Mohr's circle of the largest and the smallest stress with the localization ellipse
/// (5.25)-(5.27).
struct Contact {
  double coefficient;      ///< H^cr
  double cos_twice_angle;  ///< cos(2 theta^cr)
};

Contact contact(const Eigen::Vector3d& s, const ElasticModuli& moduli) {
  const double g = moduli.shear();
  const double k = moduli.bulk();
  const double mean = s.sum() / 3;            // sigma_0
  const double center = 0.5 * (s[0] + s[2]);  // sigma_c
  const double radius = 0.5 * (s[0] - s[2]);  // r
  const double cosine = std::clamp(3 * g * (center - mean) / ((g + 3 * k) * radius), -1.0, 1.0);
  const double normal = center + radius * cosine - mean;
  const double shear_squared = radius * radius * (1 - cosine * cosine);
  return {1 / (3 * normal * normal / (4 * g + 3 * k) + shear_squared / g), cosine};
}

double second_invariant(const Eigen::Vector3d& s) {
  return 0.5 * (s.array() - s.sum() / 3).square().sum();
}

}  // namespace

bool loses_ellipticity(double modulus, const Bifurcation& found, const ElasticModuli& moduli) {
  return modulus <= found.critical_modulus + 1e-12 * moduli.youngs_modulus;
}

double critical_coefficient(const Eigen::Vector3d& s, const ElasticModuli& moduli) {
  return contact(s, moduli).coefficient;
}

Bifurcation bifurcation(const Eigen::Vector3d& s, const ElasticModuli& moduli) {
  const double g = moduli.shear();
  const Contact c = contact(s, moduli);
  // (5.23) solved for the modulus at H = H^cr.
  const double modulus =
      std::sqrt(1.5) * (2 * g * g / (second_invariant(s) * c.coefficient) - 2 * g);
  return {std::min(0.0, modulus), 0.5 * std::acos(c.cos_twice_angle)};
}

Bifurcation plane_stress_bifurcation(double first, double second, const ElasticModuli& moduli) {
  const double n1 = (2 * first - second) / 3;
  const double n2 = (2 * second - first) / 3;
  const double length = std::sqrt(n1 * n1 + n2 * n2 + (n1 + n2) * (n1 + n2));
  if (n2 > 0) return {-std::sqrt(1.5) * moduli.youngs_modulus * std::pow(n2 / length, 2), 0};
  if (n1 < 0) {
    return {-std::sqrt(1.5) * moduli.youngs_modulus * std::pow(n1 / length, 2), M_PI / 2};
  }
  return {0, std::atan2(std::sqrt(-n2), std::sqrt(n1))};
}

Bifurcation source_membrane_bifurcation(double first, double second, const ElasticModuli& moduli) {
  Eigen::Vector3d s(first, second, 0);
  std::sort(s.data(), s.data() + 3, [](double a, double b) { return a > b; });
  return bifurcation(s, moduli);
}

}  // namespace zona::mpm
