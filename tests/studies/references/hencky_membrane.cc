#include "studies/references/hencky_membrane.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mpm/points/errors.h"

using namespace zona::studies::references;

namespace {

PressurisedDisc disc_with(double nu) {
  return {0.1, 1e-3, 1e6, nu, 100};
}

/// The same theory by shooting: N_r' = (N_t - N_r)/r and (N_r + N_t)' = -E h w'^2/(2 r) from the
/// middle with a guessed tension, by Runge and Kutta's rule; the guess is right when N_t = nu N_r
/// at the edge. Lengths in a, tensions in E h.
struct Shooting {
  double edge, deflection;
};
Shooting shoot(double middle_tension, double load, double nu) {
  const int n = 4000;
  const double h = 1.0 / n;
  // State: N_r and S = N_r + N_t; near the middle both are flat.
  const auto rates = [&](double r, double radial, double sum, double* d) {
    const double slope = -load * r / (2 * radial);
    d[0] = r > 0 ? (sum - 2 * radial) / r : 0;
    d[1] = r > 0 ? -slope * slope / (2 * r) : 0;
    d[2] = slope;
  };
  double y[3] = {middle_tension, 2 * middle_tension, 0};
  for (int i = 0; i < n; ++i) {
    const double r = i * h;
    double k[4][3];
    rates(r, y[0], y[1], k[0]);
    rates(r + h / 2, y[0] + h / 2 * k[0][0], y[1] + h / 2 * k[0][1], k[1]);
    rates(r + h / 2, y[0] + h / 2 * k[1][0], y[1] + h / 2 * k[1][1], k[2]);
    rates(r + h, y[0] + h * k[2][0], y[1] + h * k[2][1], k[3]);
    for (int c = 0; c < 3; ++c) y[c] += h / 6 * (k[0][c] + 2 * k[1][c] + 2 * k[2][c] + k[3][c]);
  }
  return {y[1] - (1 + nu) * y[0], -y[2]};
}

}  // namespace

TEST_CASE("Hencky's coefficient and deflection have their known values") {
  // b_0 as tabulated by Fichter, NASA TP-3658 (1997).
  CHECK(HenckyMembrane(disc_with(0.2)).first_coefficient() == Approx(1.6827).epsilon(3e-5));
  CHECK(HenckyMembrane(disc_with(0.3)).first_coefficient() == Approx(1.7244).epsilon(3e-5));
  CHECK(HenckyMembrane(disc_with(0.4)).first_coefficient() == Approx(1.7769).epsilon(3e-5));
  const auto disc = disc_with(0.3);
  const HenckyMembrane membrane(disc);
  const double k = std::cbrt(disc.load());
  CHECK(membrane.deflection(0) == Approx(0.653 * disc.radius * k).epsilon(1e-3));
  CHECK(membrane.radial_tension(0) == Approx(0.431 * 1e6 * 1e-3 * k * k).epsilon(1e-3));
  CHECK(membrane.hoop_tension(0) == Approx(membrane.radial_tension(0)));
  CHECK(membrane.deflection(0.1) == Approx(0).margin(1e-12));
}

TEST_CASE("Hencky's series is the solution that shooting finds") {
  for (double nu : {0.0, 0.3, 0.45, 0.5}) {
    const auto disc = disc_with(nu);
    const HenckyMembrane membrane(disc);
    const double scale = disc.youngs_modulus * disc.thickness;
    double low = 0.5 * membrane.radial_tension(0) / scale, high = 4 * low;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (shoot(middle, disc.load(), nu).edge < 0 ? low : high) = middle;
    }
    // The first step from the singular middle leaves an error of the order of its square.
    CHECK(membrane.radial_tension(0) == Approx(low * scale).epsilon(1e-6));
    CHECK(membrane.deflection(0) ==
          Approx(shoot(low, disc.load(), nu).deflection * disc.radius).epsilon(1e-6));
  }
}

TEST_CASE("Hencky: equilibrium along the axis, similarity, refusals") {
  auto disc = disc_with(0.4);
  const HenckyMembrane membrane(disc);
  for (double r : {0.01, 0.05, 0.09}) {
    CHECK(-2 * membrane.radial_tension(r) * membrane.slope(r) == Approx(disc.pressure * r));
    const double d = 1e-6;
    CHECK((membrane.deflection(r + d) - membrane.deflection(r - d)) / (2 * d) ==
          Approx(membrane.slope(r)).epsilon(1e-6));
  }
  disc.pressure *= 8;
  CHECK(HenckyMembrane(disc).deflection(0) == Approx(2 * membrane.deflection(0)));
  disc.pressure = 0;
  CHECK_THROWS_AS(HenckyMembrane(disc), zona::mpm::ModelError);
}
