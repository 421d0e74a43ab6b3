#include "studies/references/meridian_element.h"

#include <cmath>

namespace zona::studies::references {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

PrincipalStresses blended(const MembraneLaw& law, double share, double along, double around) {
  PrincipalStresses s = principal_stresses(law, along, around);
  if (s.state == MembraneState::taut) return s;
  MembraneLaw plain = law;
  plain.wrinkling = Wrinkling::none;
  const PrincipalStresses u = principal_stresses(plain, along, around);
  const auto blend = [share](double& a, double b) { a += share * (b - a); };
  blend(s.first, u.first);
  blend(s.second, u.second);
  blend(s.d11, u.d11);
  blend(s.d12, u.d12);
  blend(s.d21, u.d21);
  blend(s.d22, u.d22);
  return s;
}

/// Summed strain in the axes of the element: along the meridian and around the axis.
Vector2d seen(const Vector4d& sum, const Vector4d& now) {
  const Vector2d t = (now.tail<2>() - now.head<2>()).normalized();
  return {sum[0] * t[0] * t[0] + sum[1] * t[1] * t[1] + 2 * sum[2] * t[0] * t[1], sum[3]};
}

double length_of(const MeridianElement& x) {
  return (x.tail<2>() - x.head<2>()).norm();
}

}  // namespace

/// Volume between a conical element and the axis: pi (z2 - z1)(r1^2 + r1 r2 + r2^2)/3.
ElementQuantity element_volume(const Vector4d& x) {
  const double a = x[0], b = x[2], dz = x[3] - x[1], third = M_PI / 3;
  const double square = a * a + a * b + b * b, da = 2 * a + b, db = a + 2 * b;
  ElementQuantity q{third * dz * square, third * Vector4d(dz * da, -square, dz * db, square),
                    Matrix4d::Zero()};
  q.second << 2 * dz, -da, dz, da, -da, 0, -db, 0, dz, -db, 2 * dz, db, da, 0, db, 0;
  q.second *= third;
  return q;
}

ElementQuantity meridional_stretch(const Vector4d& x, double undeformed) {
  const Vector2d span = x.tail<2>() - x.head<2>();
  const double length = span.norm();
  const Vector2d t = span / length;
  ElementQuantity q{length / undeformed, Vector4d(-t[0], -t[1], t[0], t[1]) / undeformed, {}};
  const Eigen::Matrix2d across =
      (Eigen::Matrix2d::Identity() - t * t.transpose()) / (length * undeformed);
  q.second << across, -across, -across, across;
  return q;
}

ElementStrain strain_of_stretches(StrainMeasure measure, const MeridianElement& reference,
                                  const MeridianElement& now) {
  const ElementQuantity along = meridional_stretch(now, length_of(reference));
  const double radii = reference[0] + reference[2];
  const StrainOf e1 = strain_of(measure, along.value);
  const StrainOf e2 = strain_of(measure, (now[0] + now[2]) / radii);
  return {e1.value, e2.value, e1.derivative * along.gradient,
          e2.derivative / radii * Vector4d(1, 0, 1, 0)};
}

Vector4d summed_strain(const Vector4d& sum, const Vector4d& last, const Vector4d& now) {
  const Vector2d old_span = last.tail<2>() - last.head<2>();
  const Vector2d span = now.tail<2>() - now.head<2>();
  const Vector2d middle = 0.5 * (span + old_span), change = span - old_span;
  const double square = middle.squaredNorm();
  const double radii = now[0] + now[2], old_radii = last[0] + last[2];
  return sum + Vector4d(change[0] * middle[0] / square, change[1] * middle[1] / square,
                        0.5 * (change[0] * middle[1] + change[1] * middle[0]) / square,
                        2 * (radii - old_radii) / (radii + old_radii));
}

ElementStrain strain_of_sum(const Vector4d& sum, const Vector4d& last, const Vector4d& now) {
  const auto at = [&](const Vector4d& x) { return seen(summed_strain(sum, last, x), x); };
  const Vector2d e = at(now);
  ElementStrain strain{e[0], e[1], {}, {}};
  // By differences: only the rate at which Newton's method converges depends on them.
  const double step = 1e-6 * (now.tail<2>() - now.head<2>()).norm();
  for (int i = 0; i < 4; ++i) {
    const Vector4d d = step * Vector4d::Unit(i);
    const Vector2d slope = (at(now + d) - at(now - d)) / (2 * step);
    strain.along_gradient[i] = slope[0];
    strain.around_gradient[i] = slope[1];
  }
  return strain;
}

ElementForces element_forces(const MembraneLaw& law, double unwrinkled_share,
                             const MeridianElement& reference, const MeridianElement& now,
                             const ElementStrain& strain) {
  const double radii = reference[0] + reference[2], length = length_of(reference);
  const ElementQuantity along = meridional_stretch(now, length);
  const double stretch1 = along.value, stretch2 = (now[0] + now[2]) / radii;
  const Vector4d &g1 = along.gradient, g2 = Vector4d(1, 0, 1, 0) / radii;
  const PrincipalStresses s = blended(law, unwrinkled_share, strain.along, strain.around);
  const bool kirchhoff = law.stress == StressMeasure::kirchhoff;
  const double a1 = law.thickness / (kirchhoff ? stretch1 : 1.0);
  const double a2 = law.thickness / (kirchhoff ? stretch2 : 1.0);
  // Tensions per undeformed width and their derivatives.
  const double p1 = a1 * s.first, p2 = a2 * s.second;
  Vector4d dp1 = a1 * (s.d11 * strain.along_gradient + s.d12 * strain.around_gradient);
  Vector4d dp2 = a2 * (s.d21 * strain.along_gradient + s.d22 * strain.around_gradient);
  if (kirchhoff) {
    dp1 -= p1 / stretch1 * g1;
    dp2 -= p2 / stretch2 * g2;
  }
  const double area = M_PI * radii * length;
  return {area * (p1 * g1 + p2 * g2),
          area * (g1 * dp1.transpose() + g2 * dp2.transpose() + p1 * along.second)};
}

}  // namespace zona::studies::references
