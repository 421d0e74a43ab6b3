#include "mpm/materials/solid.h"

#include <catch2/catch.hpp>

#include "mpm/points/errors.h"

using namespace zona::mpm;

namespace {

VelocityGradient gradient_of(int i, int j, double value) {
  VelocityGradient l{};
  l[i][j] = broadcast(value);
  return l;
}

}  // namespace

TEST_CASE("Uniaxial strain and shear of a linear elastic solid") {
  const ElasticProperties p{2700, 70e9, 0.33};
  LinearElastic solid(p, 8);
  solid.update(PointGroup(0), gradient_of(0, 0, 1e-6), 1, 1);
  const double lambda = 70e9 * 0.33 / (1.33 * 0.34), g = 70e9 / 2.66;
  CHECK(solid.stress[0][0] == Approx((lambda + 2 * g) * 1e-6).epsilon(1e-12));
  CHECK(solid.stress[1][0] == Approx(lambda * 1e-6).epsilon(1e-12));
  LinearElastic sheared(p, 8);
  sheared.update(PointGroup(0), gradient_of(1, 2, 1e-6), 1, 1);
  CHECK(sheared.stress[4][0] == Approx(g * 1e-6).epsilon(1e-12));
  CHECK(solid.wave_speed() == Approx(std::sqrt((lambda + 2 * g) / 2700)));
}

TEST_CASE("Stress turns with the body, first order in the step") {
  const ElasticProperties p{1000, 1e7, 0.2};
  const auto error = [&](int steps, int i, int j) {
    LinearElastic solid(p, 8);
    const double s[6] = {3, -1, 2, 0.5, 0.7, -0.4};
    for (int c = 0; c < 6; ++c) solid.stress[c].assign(8, s[c]);
    VelocityGradient l{};
    const double angle = 1;
    l[i][j] = broadcast(-angle / steps);
    l[j][i] = broadcast(angle / steps);
    for (int n = 0; n < steps; ++n) solid.update(PointGroup(0), l, 1, 1);
    double sigma[3][3] = {{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}, r[3][3] = {};
    r[3 - i - j][3 - i - j] = 1;
    r[i][i] = r[j][j] = std::cos(angle);
    r[i][j] = -std::sin(angle);
    r[j][i] = std::sin(angle);
    constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
    double worst = 0;
    for (int c = 0; c < 6; ++c) {
      double turned = 0;
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) turned += r[row[c]][a] * sigma[a][b] * r[column[c]][b];
      }
      worst = std::max(worst, std::abs(solid.stress[c][0] - turned));
    }
    return worst;
  };
  for (auto [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
    CHECK(error(2000, i, j) < 5e-3);
    CHECK(error(1000, i, j) / error(2000, i, j) == Approx(2).epsilon(0.05));
  }
}

TEST_CASE("Invalid solids are refused") {
  CHECK_THROWS_AS(LinearElastic({1000, 1e7, 0.5}, 1), ModelError);
  CHECK_THROWS_AS(LinearElastic({1000, -1, 0.2}, 1), ModelError);
}
