#include "mpm/materials/elastodamage.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

#include "mpm/materials/elastodamage_solid.h"
#include "mpm/points/errors.h"
#include "tests/mpm/materials/solid_point.h"

using namespace zona::mpm;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const ElasticProperties shell{1100, 17.9e3, 0.49};

Matrix3d elastic_stress(const Matrix3d& strain) {
  const ElasticModuli e = shell.moduli();
  return 2 * e.shear() * strain + e.lame_first() * strain.trace() * Matrix3d::Identity();
}

}  // namespace

TEST_CASE("Figure 5.7: remaining stiffness by c0 and c1") {
  for (double c0 : {0.25, 0.5, 1.0}) {
    const Elastodamage law{c0, 1, 0.05};
    CHECK(law.integrity(0) == 1);
    CHECK(law.integrity(1) == Approx(1 - c0 * (1 - std::exp(-1.0))));
  }
  CHECK(Elastodamage{1, 1, 0.05}.failure_strain() == HUGE_VAL);
  CHECK(Elastodamage{1, 10, 0.05}.integrity(2) < Elastodamage{1, 1, 0.05}.integrity(2));
}

TEST_CASE("A damaged solid: uniaxial strain, unloading along the secant, failure at 0.06") {
  const Elastodamage law;
  SolidPoint<Elastodamage> point(shell, law);
  const Matrix3d step = Vector3d(1e-4, 0, 0).asDiagonal();
  for (int s = 1; s <= 598; ++s) {
    point.step(step);
    const double left = law.integrity(law.damage(1e-4 * s));
    CHECK(point.stress()(0, 0) ==
          Approx(left * shell.moduli().constrained() * 1e-4 * s).epsilon(1e-9));
  }
  const Matrix3d loaded = point.stress();
  for (int s = 0; s < 299; ++s) point.step(-step);
  CHECK((point.stress() - 0.5 * loaded).norm() < 1e-9 * loaded.norm());
  for (int s = 0; s < 303; ++s) point.step(step);
  CHECK(point.solid.state.failed(0));
  CHECK(point.stress().norm() == 0);
  for (int s = 0; s < 700; ++s) point.step(-step);  // no recovery, not even in compression
  CHECK(point.stress().norm() == 0);
}

TEST_CASE("Damage follows the largest principal strain, in any axes") {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  const Elastodamage law{2, 3, 0.01};
  for (int trial = 0; trial < 100; ++trial) {
    Matrix3d strain;
    for (int i = 0; i < 9; ++i) strain(i) = 0.01 * normal(random);
    strain = 0.5 * (strain + strain.transpose()).eval();
    SolidPoint<Elastodamage> point(shell, law);
    point.step(strain);
    const double largest = strain.selfadjointView<Eigen::Lower>().eigenvalues()[2];
    CHECK(point.solid.state.integrity[0] ==
          Approx(law.integrity(law.damage(largest))).epsilon(1e-10));
    CHECK((point.stress() - law.integrity(law.damage(largest)) * elastic_stress(strain)).norm() <
          1e-9 * elastic_stress(strain).norm());
  }
}

TEST_CASE("A damaged solid that turns keeps its strain and its damage") {
  SolidPoint<Elastodamage> point(shell, Elastodamage{0.5, 3, 0.01});
  point.step(Vector3d(0.02, -0.005, 0.001).asDiagonal());
  const Matrix3d before = point.stress();
  const double integrity = point.solid.state.integrity[0];
  CHECK(integrity < 0.6);
  const int steps = 4000;
  Matrix3d spin = Matrix3d::Zero();
  spin(0, 1) = -1.0 / steps;
  spin(1, 0) = 1.0 / steps;
  for (int s = 0; s < steps; ++s) point.step(spin);
  const Matrix3d r = Eigen::AngleAxisd(1, Vector3d::UnitZ()).toRotationMatrix();
  // First order in the step: the strain grows by 1/(2 steps) of itself.
  CHECK((point.stress() - r * before * r.transpose()).norm() < 2e-3 * before.norm());
  CHECK(point.solid.state.integrity[0] == Approx(integrity).epsilon(1e-3));
}

TEST_CASE("Invalid elastodamage is refused") {
  CHECK_THROWS_AS(check(Elastodamage{10, 10, 0}), ModelError);
  CHECK_THROWS_AS(check(Elastodamage{-1, 10, 0.1}), ModelError);
  CHECK_THROWS_AS(Solid<Elastodamage>(shell, 1, Elastodamage{1, -1, 0.1}), ModelError);
}
