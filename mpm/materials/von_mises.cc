#include "mpm/materials/von_mises.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mpm/points/errors.h"

namespace zona::mpm {

namespace {

const double sqrt_two_thirds = std::sqrt(2.0 / 3.0);

/// Strength [Pa] on the softening line, extended to any internal variable.
double softening_line(const VonMises& m, double internal) {
  return m.peak_strength - m.softening_modulus * (internal - m.peak_strain());
}

}  // namespace

double VonMises::strength(double internal) const {
  if (internal < peak_strain()) return yield_strength + hardening_modulus * internal;
  return std::max(0.0, softening_line(*this, internal));
}

void check(const VonMises& m) {
  if (!(m.yield_strength > 0)) {
    throw ModelError(
        fmt::format("the yield strength must be positive, got {} Pa", m.yield_strength));
  }
  if (!(m.peak_strength >= m.yield_strength)) {
    throw ModelError(fmt::format("the peak strength of {} Pa is below the yield strength of {} Pa",
                                 m.peak_strength, m.yield_strength));
  }
  if (!(m.hardening_modulus >= 0) || !(m.softening_modulus >= 0)) {
    throw ModelError(
        fmt::format("hardening and softening modulus must not be negative, got {} and {} Pa",
                    m.hardening_modulus, m.softening_modulus));
  }
  if (m.peak_strength > m.yield_strength && !(m.hardening_modulus > 0)) {
    throw ModelError(
        fmt::format("without a hardening modulus the strength cannot rise from {} Pa to its peak "
                    "of {} Pa; give a hardening modulus, or make the two strengths equal",
                    m.yield_strength, m.peak_strength));
  }
  if (m.decohesion) check(*m.decohesion);
}

double tangent_coefficient(double modulus, double shear_modulus, double j2) {
  return 4 * shear_modulus * shear_modulus /
         (2 * j2 * (2 * shear_modulus + sqrt_two_thirds * modulus));
}

PlasticFlow return_along(const VonMises& m, double trial, double internal, double stiffness) {
  if (internal < m.peak_strain()) {
    const double increment = (trial - m.strength(internal)) / (stiffness + m.hardening_modulus);
    if (internal + increment <= m.peak_strain()) return {trial - stiffness * increment, increment};
  }
  const double slope = stiffness - m.softening_modulus;
  if (slope > 0) {
    const double increment = (trial - softening_line(m, internal)) / slope;
    const double left = trial - stiffness * increment;
    if (left > 0) return {left, increment};
  }
  return {0, trial / stiffness};
}

double radial_stiffness(double shear_modulus) {
  return std::sqrt(6.0) * shear_modulus;
}

double equivalent_stress(const PlaneTensor& s) {
  return std::sqrt(s.xx * s.xx + s.yy * s.yy - s.xx * s.yy + 3 * s.xy * s.xy);
}

PlaneStressFlow::PlaneStressFlow(const PlaneTensor& trial, const ElasticModuli& moduli)
    : sum_((trial.xx + trial.yy) * std::sqrt(0.5)),
      difference_((trial.yy - trial.xx) * std::sqrt(0.5)),
      shear_(trial.xy),
      two_g_(2 * moduli.shear()),
      ratio_(moduli.youngs_modulus / (3 * (1 - moduli.poisson_ratio)) / two_g_) {}

PlaneTensor PlaneStressFlow::stress(double t) const {
  const double mean = sum_ * (1 - t) / (1 - t + ratio_ * t) * std::sqrt(0.5);
  const double half = difference_ * (1 - t) * std::sqrt(0.5);
  return {mean - half, mean + half, shear_ * (1 - t)};
}

PlaneTensor PlaneStressFlow::plastic_strain(double t) const {
  // x times the deviatoric stress; finite also where x is not.
  const double mean = sum_ * t / (1 - t + ratio_ * t) / two_g_ * std::sqrt(0.5) / 3;
  const double half = difference_ * t / two_g_ * std::sqrt(0.5);
  return {mean - half, mean + half, shear_ * t / two_g_};
}

double PlaneStressFlow::equivalent_stress(double t) const {
  return mpm::equivalent_stress(stress(t));
}

double PlaneStressFlow::increment(double t) const {
  const auto [xx, yy, xy] = plastic_strain(t);
  const double zz = -xx - yy;
  return std::sqrt(xx * xx + yy * yy + zz * zz + 2 * xy * xy);
}

/// Finds t at which the equivalent stress equals strength + modulus * increment. The increment is
/// sqrt(2/3) x q, so the equation is q (1 + b t/(1 - t)) = strength with
/// b = -sqrt(2/3) modulus / (2 G). Its square has two terms,
///     sum^2/2 ((1 - t + b t)/(1 - t + r t))^2 + (3/2 difference^2 + 3 shear^2) (1 - t + b t)^2.
/// For b < r both decrease: there is at most one root, which Newton's method finds between two
/// bounds. For r <= b < 1 the sum is convex: Newton's method from t = 0 finds the first root, if
/// there is one.
double PlaneStressFlow::intersect_line(double strength, double modulus) const {
  const double b = -sqrt_two_thirds * modulus / two_g_;
  const double of_sum = 0.5 * sum_ * sum_;
  const double of_rest = 1.5 * difference_ * difference_ + 3 * shear_ * shear_;
  if (strength <= 0 || b >= 1) return 1;
  const bool one_root = b < ratio_;
  const double left_at_end = of_sum * b * b / (ratio_ * ratio_) + of_rest * b * b;
  if (one_root && b >= 0 && left_at_end >= strength * strength) return 1;
  double low = 0;
  double high = b < 0 ? 1 / (1 - b) : 1;
  double t = 0;
  for (int i = 0; i < 100; ++i) {
    const double shrink = 1 - t + ratio_ * t;
    const double line = 1 - t + b * t;
    const double f = line * line * (of_sum / (shrink * shrink) + of_rest) - strength * strength;
    const double slope =
        2 * line * (of_sum * (b - ratio_) / (shrink * shrink * shrink) + of_rest * (b - 1));
    if (!one_root && f <= 0) return t;
    if (!one_root && slope >= 0) return 1;
    (f > 0 ? low : high) = t;
    double next = t - f / slope;
    if (std::abs(next - t) <= 1e-16) return t;
    if (!one_root && next >= 1) return 1;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    t = next;
  }
  return t;
}

double PlaneStressFlow::end(const VonMises& m, double internal) const {
  if (internal < m.peak_strain()) {
    const double t = intersect_line(m.strength(internal), m.hardening_modulus);
    if (internal + increment(t) <= m.peak_strain()) return t;
  }
  return intersect_line(softening_line(m, internal), -m.softening_modulus);
}

double PlaneStressFlow::at_increment(double wanted) const {
  if (increment(1) <= wanted) return 1;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (increment(middle) > wanted ? high : low) = middle;
  }
  return low;
}

}  // namespace zona::mpm
