#include "mpm/materials/von_mises.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

#include "mpm/materials/von_mises_solid.h"
#include "mpm/points/errors.h"
#include "tests/mpm/materials/solid_point.h"

using namespace zona::mpm;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const ElasticProperties steel{7800, 200e9, 0.3};
/// Hardens, then softens slowly enough for the strength to fall with the strain.
const VonMises softening{300e6, 330e6, 5e9, 20e9, {}};

Matrix3d random_symmetric(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i) = normal(random);
  return 0.5 * (m + m.transpose());
}

Matrix3d simple_shear(double gamma) {
  Matrix3d strain = Matrix3d::Zero();
  strain(0, 1) = strain(1, 0) = 0.5 * gamma;
  return strain;
}

/// The shear stress that a monotonic shear gives: on each straight piece of the strength,
/// q = sqrt(3) G gamma - sqrt(6) G I = strength(I).
double exact_shear_stress(const VonMises& m, double g, double gamma) {
  const double trial = std::sqrt(3.0) * g * gamma, slope = std::sqrt(6.0) * g;
  if (trial <= m.yield_strength) return trial / std::sqrt(3.0);
  const double hardened = (trial - m.yield_strength) / (slope + m.hardening_modulus);
  if (hardened <= m.peak_strain()) return m.strength(hardened) / std::sqrt(3.0);
  const double softened =
      (trial - slope * m.peak_strain() - m.peak_strength) / (slope - m.softening_modulus);
  return std::max(0.0, m.peak_strength - m.softening_modulus * softened) / std::sqrt(3.0);
}

}  // namespace

TEST_CASE("The strength rises to its peak, falls, and stays at zero") {
  CHECK(softening.peak_strain() == Approx(30e6 / 5e9));
  CHECK(softening.strength(0) == 300e6);
  CHECK(softening.strength(0.003) == Approx(315e6));
  CHECK(softening.strength(0.006 + 1e-3) == Approx(310e6));
  CHECK(softening.strength(1) == 0);
  CHECK(VonMises::perfectly_plastic(300e6).strength(5) == 300e6);
  // The zona (5.4): the peak is reached at once.
  CHECK(VonMises{1062.795, 1062.805, 17.9, 179e3, {}}.peak_strain() == Approx(5.5866e-4));
}

TEST_CASE("Shear follows the closed form through yield, peak and the end of the strength") {
  const double g = steel.moduli().shear();
  for (int steps : {1, 7, 500}) {
    for (double gamma : {0.001, 0.004, 0.012, 0.02, 0.0374, 0.05}) {
      SolidPoint<VonMises> point(steel, softening);
      for (int s = 0; s < steps; ++s) point.step(simple_shear(gamma / steps));
      INFO(gamma << " in " << steps);
      // Proportional strains: one step is as exact as many. Rounding of 500 steps.
      CHECK(point.stress()(0, 1) ==
            Approx(exact_shear_stress(softening, g, gamma)).epsilon(1e-11).margin(1));
    }
  }
  CHECK(exact_shear_stress(softening, g, 0.05) == 0);
  CHECK(exact_shear_stress(softening, g, 0.02) > 0);
}

TEST_CASE("A bar of chapter 3 flows at 300 MPa, no hardening, Poisson's ratio zero") {
  SolidPoint<VonMises> bar({2810, 72e9, 0}, VonMises::perfectly_plastic(300e6));
  Matrix3d strain = Matrix3d::Zero();
  strain(0, 0) = 0.5 * 300e6 / 72e9;
  bar.step(strain);
  CHECK(bar.stress()(0, 0) == Approx(150e6).epsilon(1e-12));
  for (int s = 0; s < 5; ++s) bar.step(strain);
  CHECK(equivalent_stress_of(bar.stress()) == Approx(300e6).epsilon(1e-12));
  bar.step(-strain);  // unloads elastically
  CHECK(equivalent_stress_of(bar.stress()) < 300e6 * (1 - 1e-3));
}

TEST_CASE("Softening that snaps back removes all strength and no pressure") {
  const VonMises zona{1062.795, 1062.805, 17.9, 179e3, {}};
  const ElasticProperties soft{1100, 17.9e3, 0.49};
  CHECK(tangent_coefficient(-179e3, soft.moduli().shear(), 1) < 0);
  SolidPoint<VonMises> point(soft, zona);
  Matrix3d strain = simple_shear(0.12);
  strain.diagonal().setConstant(1e-4);
  point.step(strain);
  CHECK(equivalent_stress_of(point.stress()) < 1e-9);
  CHECK(point.stress()(0, 0) == Approx(3e-4 * soft.moduli().bulk()).epsilon(1e-9));
}

TEST_CASE("The stress stays on the flow surface and dissipates, whatever the path") {
  std::mt19937 random(7);
  for (const VonMises& law : {softening, VonMises::perfectly_plastic(300e6)}) {
    SolidPoint<VonMises> point(steel, law);
    double dissipated = 0;
    for (int s = 0; s < 400; ++s) {
      point.step(4e-4 * random_symmetric(random));
      const auto& state = point.solid.state;
      const double q = equivalent_stress_of(point.stress());
      REQUIRE(q <= law.strength(state.internal[0]) + 1e-12 * 330e6 * 10);
      REQUIRE(state.strength[0] == law.strength(state.internal[0]));
      REQUIRE(state.dissipated[0] >= dissipated);
      dissipated = state.dissipated[0];
    }
    CHECK(dissipated > 0);
  }
}

TEST_CASE("The tangent is (5.22) with (5.23), the modulus taken times sqrt(2/3)") {
  std::mt19937 random(11);
  const double g = steel.moduli().shear(), lambda = steel.moduli().lame_first();
  for (double start : {0.001, 0.02}) {  // internal variable in the hardening, softening branch
    const double modulus = start < softening.peak_strain() ? 5e9 : -20e9;
    const Matrix3d s = random_symmetric(random);
    const Matrix3d stress = softening.strength(start) / equivalent_stress_of(s) * s;
    const Matrix3d deviator = stress - stress.trace() / 3 * Matrix3d::Identity();
    const double h = tangent_coefficient(modulus, g, 0.5 * deviator.squaredNorm());
    for (int trial = 0; trial < 5; ++trial) {
      Matrix3d strain = random_symmetric(random);
      if (strain.cwiseProduct(deviator).sum() < 0) strain *= -1;  // loading
      const Matrix3d elastic = 2 * g * strain + lambda * strain.trace() * Matrix3d::Identity();
      const Matrix3d exact = elastic - h * deviator.cwiseProduct(strain).sum() * deviator;
      SolidPoint<VonMises> point(steel, softening);
      point.set_stress(stress);
      point.solid.state.internal[0] = start;
      point.solid.state.strength[0] = softening.strength(start);
      const double small = 1e-9;
      point.step(small * strain);
      // First order in the step, some 2 G |strain| / strength = 5e3 of it; rounding eps / small.
      CHECK(((point.stress() - stress) / small - exact).norm() < 1e-5 * exact.norm());
    }
  }
}

TEST_CASE("A plastic solid is isotropic, and its stress turns with it") {
  std::mt19937 random(3);
  const Matrix3d turn = Eigen::AngleAxisd(0.9, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  SolidPoint<VonMises> straight(steel, softening), turned(steel, softening);
  for (int s = 0; s < 50; ++s) {
    const Matrix3d strain = 5e-4 * random_symmetric(random);
    straight.step(strain);
    turned.step(turn * strain * turn.transpose());
  }
  CHECK((turned.stress() - turn * straight.stress() * turn.transpose()).norm() < 1e-9 * 300e6);
  CHECK(turned.solid.state.internal[0] == Approx(straight.solid.state.internal[0]).epsilon(1e-10));

  const Matrix3d before = straight.stress();
  const double internal = straight.solid.state.internal[0];
  const int steps = 2000;
  Matrix3d spin = Matrix3d::Zero();
  spin(0, 1) = -1.0 / steps;
  spin(1, 0) = 1.0 / steps;
  for (int s = 0; s < steps; ++s) straight.step(spin);
  const Matrix3d r = Eigen::AngleAxisd(1, Vector3d::UnitZ()).toRotationMatrix();
  // The rotation is of first order in the step and lengthens the deviator by up to 1/(2 steps) per
  // radian; what exceeds the strength flows back.
  CHECK((straight.stress() - r * before * r.transpose()).norm() < 5e-3 * before.norm());
  CHECK(straight.solid.state.internal[0] - internal < 1e-3 * 300e6 / steel.moduli().shear());
}

TEST_CASE("Plane stress: the stress of the solid whose thickness strain frees it") {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const ElasticModuli e = steel.moduli();
  int across_peak = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const PlaneTensor strain{6e-3 * normal(random), 6e-3 * normal(random), 6e-3 * normal(random)};
    const double start = trial % 2 ? 0 : 0.004;
    const PlaneTensor elastic{e.plane_stress() * (strain.xx + e.poisson_ratio * strain.yy),
                              e.plane_stress() * (strain.yy + e.poisson_ratio * strain.xx),
                              2 * e.shear() * strain.xy};
    if (equivalent_stress(elastic) <= softening.strength(start)) continue;
    const PlaneStressFlow flow(elastic, e);
    const double t = flow.end(softening, start);
    if (t == 1) continue;  // see below
    across_peak += start + flow.increment(t) > softening.peak_strain();
    CHECK(flow.equivalent_stress(t) ==
          Approx(softening.strength(start + flow.increment(t))).epsilon(1e-12));

    // The solid, its thickness strain by bisection until no stress acts on the plane.
    const auto solid_at = [&](double thickness_strain) {
      SolidPoint<VonMises> point(steel, softening);
      point.solid.state.internal[0] = start;
      point.solid.state.strength[0] = softening.strength(start);
      Matrix3d s = Matrix3d::Zero();
      s.diagonal() << strain.xx, strain.yy, thickness_strain;
      s(0, 1) = s(1, 0) = strain.xy;
      point.step(s);
      return point;
    };
    double low = -0.1, high = 0.1;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      (solid_at(middle).stress()(2, 2) > 0 ? high : low) = middle;
    }
    const auto solid = solid_at(low);
    const PlaneTensor stress = flow.stress(t);
    // Bisection ends at the rounding of a strain, 1e-17 of a modulus of 3e11 Pa.
    CHECK(stress.xx == Approx(solid.stress()(0, 0)).epsilon(1e-9).margin(1));
    CHECK(stress.yy == Approx(solid.stress()(1, 1)).epsilon(1e-9).margin(1));
    CHECK(stress.xy == Approx(solid.stress()(0, 1)).epsilon(1e-9).margin(1));
    CHECK(start + flow.increment(t) == Approx(solid.solid.state.internal[0]).epsilon(1e-9));
    // The thickness strain follows from Hooke's law and incompressible flow: no stress.
    const auto plastic = flow.plastic_strain(t);
    const double elastic_zz = low + plastic.xx + plastic.yy;
    const double out_of_plane =
        e.lame_first() * (strain.xx - plastic.xx + strain.yy - plastic.yy + elastic_zz) +
        2 * e.shear() * elastic_zz;
    CHECK(std::abs(out_of_plane) < 1e-9 * 300e6);
  }
  CHECK(across_peak > 20);
}

TEST_CASE("Plane stress: no stress remains where the strength ends or the softening snaps back") {
  const ElasticModuli e = steel.moduli();
  for (const VonMises& law : {softening, VonMises{300e6, 330e6, 5e9, 1e12, {}}}) {
    const PlaneStressFlow flow({2e10, -1e10, 3e9}, e);
    const double t = flow.end(law, 0);
    CHECK(t == 1);
    CHECK(equivalent_stress(flow.stress(t)) == 0);
    // All elastic strain became plastic.
    CHECK(flow.plastic_strain(t).xx == Approx((2e10 + 0.3 * 1e10) / 200e9));
    CHECK(flow.plastic_strain(t).xy == Approx(3e9 * 1.3 / 200e9));
  }
  const PlaneStressFlow flow({5e8, 1e8, 1e8}, e);
  const double t = flow.at_increment(1e-3);
  CHECK(flow.increment(t) == Approx(1e-3).epsilon(1e-12));
}

TEST_CASE("Invalid von Mises models are refused") {
  CHECK_THROWS_AS(check(VonMises{0, 1, 1, 1, {}}), ModelError);
  CHECK_THROWS_WITH(check(VonMises{2, 1, 1, 1, {}}), Catch::Contains("below the yield strength"));
  CHECK_THROWS_AS(check(VonMises{1, 1, -1, 0, {}}), ModelError);
  CHECK_THROWS_AS(check(VonMises{1, 1, 0, -1, {}}), ModelError);
  CHECK_THROWS_WITH(check(VonMises{1, 2, 0, 0, {}}), Catch::Contains("hardening modulus"));
  CHECK_NOTHROW(check(VonMises::perfectly_plastic(1)));
  CHECK_THROWS_AS(Solid<VonMises>({1000, 1, 0.3}, 1, VonMises{}), ModelError);
}
