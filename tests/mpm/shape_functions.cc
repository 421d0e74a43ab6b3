#include "mpm/shape_functions.h"

#include <catch2/catch.hpp>
#include <random>

using namespace zona::mpm;

TEST_CASE("Transposing eight rows of lanes twice gives them back") {
  Lanes rows[8];
  for (int r = 0; r < 8; ++r) {
    for (int l = 0; l < 8; ++l) rows[r][l] = 10 * r + l;
  }
  transpose(rows);
  for (int r = 0; r < 8; ++r) {
    for (int l = 0; l < 8; ++l) CHECK(rows[r][l] == 10 * l + r);
  }
}

TEST_CASE("Trilinear shape functions sum to one and reproduce linear fields") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 100; ++trial) {
    const double s[3] = {unit(random), unit(random), unit(random)};
    const auto f = trilinear::factors(s[0], s[1], s[2]);
    const Lanes shape = f.x * f.y * f.z;
    const Lanes gradient[3] = {trilinear::sign_x * f.y * f.z, trilinear::sign_y * f.x * f.z,
                               trilinear::sign_z * f.x * f.y};
    double sum = 0, place[3] = {0, 0, 0}, slope_sum[3] = {0, 0, 0}, slope[3][3] = {};
    for (int n = 0; n < 8; ++n) {
      sum += shape[n];
      for (int i = 0; i < 3; ++i) {
        const int corner = (n >> i) & 1;
        place[i] += shape[n] * corner;
        slope_sum[i] += gradient[i][n];
        for (int j = 0; j < 3; ++j) slope[i][j] += gradient[j][n] * corner;
      }
    }
    // Eight terms of order one: a few ulp.
    CHECK(sum == Approx(1).epsilon(1e-15));
    for (int i = 0; i < 3; ++i) {
      CHECK(place[i] == Approx(s[i]).margin(1e-15));
      CHECK(std::abs(slope_sum[i]) < 1e-15);
      for (int j = 0; j < 3; ++j) CHECK(slope[i][j] == Approx(i == j ? 1 : 0).margin(1e-15));
    }
  }
}

TEST_CASE("Coefficients give the same interpolation and derivatives as shape functions") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  double node[8], c[8];
  for (int n = 0; n < 8; ++n) c[n] = node[n] = unit(random);
  trilinear::to_coefficients(c);
  const double s[3] = {unit(random), unit(random), unit(random)};
  const std::array<Lanes, 3> natural{broadcast(s[0]), broadcast(s[1]), broadcast(s[2])};
  const auto f = trilinear::factors(s[0], s[1], s[2]);
  double value = 0, slope[3] = {0, 0, 0};
  for (int n = 0; n < 8; ++n) {
    value += node[n] * f.x[n] * f.y[n] * f.z[n];
    slope[0] += node[n] * trilinear::sign_x[n] * f.y[n] * f.z[n];
    slope[1] += node[n] * trilinear::sign_y[n] * f.x[n] * f.z[n];
    slope[2] += node[n] * trilinear::sign_z[n] * f.x[n] * f.y[n];
  }
  CHECK(trilinear::interpolate(c, 1, natural)[3] == Approx(value).epsilon(1e-14));
  const auto derivative = trilinear::derivatives(c, 1, natural);
  for (int i = 0; i < 3; ++i) CHECK(derivative[i][5] == Approx(slope[i]).epsilon(1e-13));
}
