#include "mpm/materials/bifurcation.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

#include "mpm/materials/von_mises.h"

using namespace zona::mpm;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Matrix3d deviator_of(const Vector3d& principal) {
  return (principal.array() - principal.sum() / 3).matrix().asDiagonal();
}

/// det(n . E_T . n) over det(n . E . n), (5.22) and (5.24).
double determinant(const Vector3d& n, const Vector3d& principal, double h, const ElasticModuli& e) {
  const Matrix3d q =
      e.shear() * Matrix3d::Identity() + (e.lame_first() + e.shear()) * n * n.transpose();
  const Vector3d a = deviator_of(principal) * n;
  return (q - h * a * a.transpose()).determinant() / q.determinant();
}

/// Direction, out of very many, whose determinant 1 - H a.Q^-1.a vanishes first when H grows, and
/// that H.
struct Found {
  double coefficient;
  Vector3d normal;
};

Found search(const Vector3d& principal, const ElasticModuli& e) {
  Found best{HUGE_VAL, {}};
  const auto consider = [&](double azimuth, double height) {
    const Vector3d n(std::cos(azimuth) * std::cos(height), std::sin(azimuth) * std::cos(height),
                     std::sin(height));
    const double at_one = determinant(n, principal, 1, e);
    const double coefficient = 1 / (1 - at_one);
    if (coefficient > 0 && coefficient < best.coefficient) best = {coefficient, n};
    return best.normal == n;
  };
  double azimuth = 0, height = 0;
  double span = M_PI / 2;
  for (int level = 0; level < 6; ++level, span /= 20) {
    const double a0 = azimuth, h0 = height;
    for (int i = -60; i <= 60; ++i) {
      for (int j = -60; j <= 60; ++j) {
        if (consider(a0 + span * i / 60, h0 + span * j / 60)) {
          azimuth = a0 + span * i / 60;
          height = h0 + span * j / 60;
        }
      }
    }
  }
  return best;
}

/// The plane stress tangent (tensor components xx yy xy, the shear counted twice in products) at
/// in-plane principal stresses, for a strength that changes by `modulus`.
Matrix3d plane_stress_tangent(double s1, double s2, double modulus, const ElasticModuli& e) {
  Matrix3d d = Matrix3d::Zero();  // acts on (xx, yy, 2 xy)
  const double m = e.plane_stress();
  d << m, e.poisson_ratio * m, 0, e.poisson_ratio * m, m, 0, 0, 0, e.shear();
  const Vector3d deviator((2 * s1 - s2) / 3, (2 * s2 - s1) / 3, -(s1 + s2) / 3);
  const Vector3d unit = deviator / deviator.norm();
  const Vector3d flow(unit[0], unit[1], 0);  // no shear in principal axes
  const Vector3d df = d * flow;
  return d - df * df.transpose() / (flow.dot(df) + std::sqrt(2.0 / 3) * modulus);
}

Matrix2d plane_acoustic(const Vector2d& n, const Matrix3d& d) {
  Eigen::Matrix<double, 3, 2> b;
  b << n.x(), 0, 0, n.y(), n.y(), n.x();
  return b.transpose() * d * b;
}

/// Largest modulus at which the determinant vanishes for this direction, by bisection: the
/// determinant changes from positive to negative when the modulus falls.
double critical_modulus_of(double angle, double s1, double s2, const ElasticModuli& e) {
  const Vector2d n(std::cos(angle), std::sin(angle));
  double low = -0.3 * e.youngs_modulus, high = e.youngs_modulus;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (plane_acoustic(n, plane_stress_tangent(s1, s2, middle, e)).determinant() > 0 ? high : low) =
        middle;
  }
  return high;
}

}  // namespace

TEST_CASE("Three dimensions: (5.28) and (5.29) against a search over directions") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> even(-1, 1);
  for (double nu : {0.0, 0.3, 0.49}) {
    const ElasticModuli e{3, nu};
    for (int trial = 0; trial < 12; ++trial) {
      Vector3d s(even(random), even(random), even(random));
      if (trial == 0) s = Vector3d(1, 0, 0);  // uniaxial
      if (trial == 1) s = Vector3d(0, 0, -1);
      if (trial == 2) s = Vector3d(1, 0, -1);  // shear
      std::sort(s.data(), s.data() + 3, std::greater<>());
      const Found found = search(s, e);
      const Bifurcation b = bifurcation(s, e);
      // The last level of the search resolves 1e-7 rad; the minimum is flat.
      CHECK(critical_coefficient(s, e) == Approx(found.coefficient).epsilon(1e-9));
      const Vector3d n(std::cos(b.angle), 0, std::sin(b.angle));
      CHECK(std::abs(determinant(n, s, found.coefficient, e)) < 1e-8);
      if (std::abs(s[0] - s[1]) > 0.05 && std::abs(s[1] - s[2]) > 0.05) {
        CHECK(std::abs(found.normal[0]) == Approx(std::cos(b.angle)).margin(1e-5));
        CHECK(std::abs(found.normal[2]) == Approx(std::sin(b.angle)).margin(1e-5));
      }
      const double j2 = 0.5 * deviator_of(s).squaredNorm();
      // At the critical modulus (5.23) is H^cr.
      if (b.critical_modulus < 0) {
        CHECK(tangent_coefficient(b.critical_modulus, e.shear(), j2) ==
              Approx(found.coefficient).epsilon(1e-8));
      }
      CHECK(loses_ellipticity(1.01 * b.critical_modulus - 1e-9, b, e));
      CHECK_FALSE(loses_ellipticity(0.99 * b.critical_modulus + 1e-9, b, e));
    }
  }
}

TEST_CASE("Three dimensions: shear localises without softening, tension only with it") {
  const ElasticModuli e{17.9e3, 0.49};
  CHECK(bifurcation({1, 0, -1}, e).critical_modulus == Approx(0).margin(1e-9 * e.youngs_modulus));
  CHECK(bifurcation({1, 0, -1}, e).angle == Approx(M_PI / 4));
  CHECK(bifurcation({1, 0, 0}, e).critical_modulus < -100);
  // The softening of the zona snaps back at a point: H is negative, the bifurcation long past.
  CHECK(tangent_coefficient(-179e3, e.shear(), 1) < 0);
  CHECK(loses_ellipticity(-179e3, bifurcation({1, 0, 0}, e), e));
  CHECK_FALSE(loses_ellipticity(17.9, bifurcation({1, 0, -1}, e), e));
}

TEST_CASE("Three dimensions: the contact at the top or bottom of Mohr's circle needs K < 0") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> even(-1, 1);
  for (int trial = 0; trial < 1000; ++trial) {
    Vector3d s(even(random), even(random), even(random));
    std::sort(s.data(), s.data() + 3, std::greater<>());
    const double angle = bifurcation(s, {1, -0.99}).angle;
    CHECK(angle > 0);
    CHECK(angle < M_PI / 2);
  }
  // E < 0 and nu < -1 make G > 0 > K with real wave speeds: (5.30)-(5.31) for tension, and for
  // compression the branch at 90 degrees that the source does not have.
  const ElasticModuli odd{-1, -1.2};
  CHECK(odd.shear() > 0);
  CHECK(odd.bulk() < 0);
  CHECK(odd.constrained() > 0);
  const double g = odd.shear(), k = odd.bulk();
  for (const auto& [s, angle] :
       {std::pair(Vector3d(1, 0, 0), 0.0), std::pair(Vector3d(0, 0, -1), M_PI / 2)}) {
    CHECK(bifurcation(s, odd).angle == Approx(angle).margin(1e-7));
    CHECK(critical_coefficient(s, odd) == Approx((4 * g + 3 * k) / (3 * 4.0 / 9)));  // (5.30)
    CHECK(critical_coefficient(s, odd) == Approx(search(s, odd).coefficient).epsilon(1e-9));
  }
}

TEST_CASE("Plane stress: the closed form against bisection over directions") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> even(-1, 1);
  for (double nu : {0.0, 0.3, 0.49}) {
    const ElasticModuli e{2, nu};
    for (int trial = 0; trial < 20; ++trial) {
      double s1 = even(random), s2 = even(random);
      if (trial == 0) s1 = 1, s2 = 0;
      if (trial == 1) s1 = 1, s2 = 0.9;
      if (trial == 2) s1 = -0.8, s2 = -1;
      if (trial == 3) s1 = 0, s2 = -1;
      if (s2 > s1) std::swap(s1, s2);
      double best = -HUGE_VAL, best_angle = 0;
      const int n = 4000;
      for (int i = 0; i <= n; ++i) {
        const double angle = 0.5 * M_PI * i / n;
        const double modulus = critical_modulus_of(angle, s1, s2, e);
        if (modulus > best) best = modulus, best_angle = angle;
      }
      const Bifurcation b = plane_stress_bifurcation(s1, s2, e);
      INFO(s1 << " " << s2);
      // The search's directions are 4e-4 rad apart; the modulus is quadratic around its maximum.
      CHECK(b.critical_modulus == Approx(best).margin(1e-6));
      CHECK(b.angle == Approx(best_angle).margin(4e-4));
    }
  }
}

TEST_CASE("Plane stress: known directions, and what the source's reading makes of them") {
  const ElasticModuli e{17.9e3, 0.49};
  const double degrees = 180 / M_PI;
  // Uniaxial tension: the line is at 54.7 degrees to the load, its normal at 35.3.
  CHECK(plane_stress_bifurcation(1, 0, e).angle * degrees == Approx(35.264).epsilon(1e-4));
  CHECK(plane_stress_bifurcation(1, -1, e).angle * degrees == Approx(45));
  CHECK(plane_stress_bifurcation(1, 0.5, e).angle == Approx(0).margin(1e-7));
  CHECK(plane_stress_bifurcation(1, 1, e).angle == 0);
  CHECK(plane_stress_bifurcation(1, 1, e).critical_modulus ==
        Approx(-std::sqrt(1.5) * e.youngs_modulus / 6));
  // Three dimensions, third stress zero: shear at about 45 degrees whatever the tension.
  CHECK(source_membrane_bifurcation(1, 0, e).angle * degrees == Approx(44.81).epsilon(1e-3));
  CHECK(source_membrane_bifurcation(1, 0.5, e).angle * degrees == Approx(45));
  CHECK(source_membrane_bifurcation(1, 1, e).angle * degrees == Approx(45.19).epsilon(1e-3));
}
