#include "studies/references/riemann_problem.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "mpm/points/errors.h"
#include "tests/mpm/step/riemann.h"

using namespace zona::studies::references;
using zona::mpm::ModelError;
using zona::mpm::StiffenedGas;

namespace {

/// Integral of a conserved density over x in [-width, width] at t = 1, by the midpoint rule.
double integral(const RiemannSolution& s, double width,
                const std::function<double(const FluidState&)>& density) {
  const int n = 400000;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += density(s.at(width * (2.0 * (i + 0.5) / n - 1)));
  return sum * 2 * width / n;
}

double flux_of_energy(const FluidState& s) {
  return s.velocity *
         (s.density * (s.internal_energy + 0.5 * s.velocity * s.velocity) + s.pressure);
}

/// What entered through both ends until t = 1 is what was added: mass, momentum, energy.
void check_conservation(const RiemannSolution& s, double width, double tolerance) {
  const FluidState &l = s.left, &r = s.right;
  const auto mass = [](const FluidState& a) { return a.density; };
  const auto momentum = [](const FluidState& a) { return a.density * a.velocity; };
  const auto energy = [](const FluidState& a) {
    return a.density * (a.internal_energy + 0.5 * a.velocity * a.velocity);
  };
  const auto balance = [&](const auto& density, const auto& flux) {
    const double before = width * (density(l) + density(r));
    const double scale = width * (std::abs(density(l)) + std::abs(density(r))) + std::abs(flux(l)) +
                         std::abs(flux(r));
    return std::abs(integral(s, width, density) - before - flux(l) + flux(r)) / scale;
  };
  CHECK(balance(mass, momentum) < tolerance);
  CHECK(balance(momentum, [&](const FluidState& a) {
          return momentum(a) * a.velocity + a.pressure;
        }) < tolerance);
  CHECK(balance(energy, flux_of_energy) < tolerance);
}

}  // namespace

TEST_CASE("shock tube of 4.4.1: the known star state, and a second solver") {
  const auto s = shock_tube_of_the_source();
  CHECK(s.left_star.pressure == Approx(0.21086).epsilon(3e-5));  // digits of the known values
  CHECK(s.right_star.velocity == Approx(1.17954).epsilon(1e-5));
  CHECK(s.right_star.density == Approx(0.72983).epsilon(1e-5));
  CHECK(s.right_wave.shock);
  CHECK_FALSE(s.left_wave.shock);
  CHECK(s.right_wave.head == Approx(1.42332).epsilon(1e-5));
  const ShockTube other{1.4, 1, 1, 0.125, 0.001};
  for (double x = -2; x < 2; x += 0.0137) {
    const auto a = s.at(x);
    const auto b = other.at(x);
    CHECK(a.density == Approx(b.density).epsilon(1e-12));
    CHECK(a.velocity == Approx(b.velocity).epsilon(1e-12).margin(1e-14));
    CHECK(a.pressure == Approx(b.pressure).epsilon(1e-12));
    CHECK(a.internal_energy == Approx(a.pressure / (0.4 * a.density)).epsilon(1e-12));
  }
}

TEST_CASE("Sod's tube and Toro's tests have their tabulated star states") {
  // Toro, table 4.3: pressure, velocity, densities left and right of the contact.
  const auto check = [](const RiemannSolution& s, double p, double u, double rho_l, double rho_r) {
    CHECK(s.left_star.pressure == Approx(p).epsilon(2e-5).margin(5e-6));  // digits of the table
    CHECK(s.left_star.velocity == Approx(u).margin(1e-5).epsilon(1e-5));
    CHECK(s.left_star.density == Approx(rho_l).epsilon(2e-4));
    CHECK(s.right_star.density == Approx(rho_r).epsilon(2e-4));
  };
  check(sods_tube(), 0.30313, 0.92745, 0.42632, 0.26557);
  check(solve_shock_tube(1.4, {1, -2, 0.4, 0}, {1, 2, 0.4, 0}), 0.00189, 0, 0.02185, 0.02185);
  check(solve_shock_tube(1.4, {1, 0, 1000, 0}, {1, 0, 0.01, 0}), 460.894, 19.5975, 0.57506,
        5.99924);
  check(solve_shock_tube(1.4, {5.99924, 19.5975, 460.894, 0}, {5.99242, -6.19633, 46.0950, 0}),
        1691.64, 8.68975, 14.2823, 31.0426);
  CHECK(sods_tube().right_wave.head == Approx(1.75216).epsilon(1e-5));
}

TEST_CASE("Riemann solutions conserve mass, momentum and energy") {
  check_conservation(shock_tube_of_the_source(), 2, 1e-5);  // cells of the sum at three jumps
  check_conservation(sods_tube(), 2, 1e-5);
  const StiffenedGas water{4, 6.13e8}, air = StiffenedGas::ideal_gas(1.4);
  check_conservation(solve_riemann(water, {1000, 3, 2e8, 0}, air, {1.2, -5, 1e5, 0}), 4000, 1e-5);
  check_conservation(solve_riemann(water, {1000, 0, 0, 0}, {4, 2.12e8}, {1000, 0, 1e7, 0}), 4000,
                     1e-5);
}

TEST_CASE("weak waves in water are acoustic, mirrored states mirror") {
  const StiffenedGas water{4, 6.13e8};
  const double c = water.sound_speed(0, 1000), p = 1e3;
  const auto s = solve_riemann(water, {1000, 0, p, 0}, water, {1000, 0, 0, 0});
  CHECK(s.right_star.pressure == Approx(p / 2).epsilon(1e-5));  // p / P_inf = 1.6e-6
  CHECK(s.right_star.velocity == Approx(p / (2 * 1000 * c)).epsilon(1e-5));
  CHECK(s.right_wave.head == Approx(c).epsilon(1e-5));
  const auto mirrored = solve_riemann(water, {1000, 0, 0, 0}, water, {1000, 0, p, 0});
  CHECK(mirrored.left_star.pressure == Approx(s.right_star.pressure).epsilon(1e-9));
  CHECK(mirrored.at(-0.5 * c).velocity == Approx(-s.at(0.5 * c).velocity).epsilon(1e-6));
}

TEST_CASE("a uniform flow stays, a vacuum is refused") {
  const auto s = solve_shock_tube(1.4, {1, 2, 3, 0}, {1, 2, 3, 0});
  for (double x : {-5.0, 1.9, 2.1, 8.0}) {
    CHECK(s.at(x).velocity == Approx(2));
    CHECK(s.at(x).pressure == Approx(3));
  }
  CHECK_THROWS_AS(solve_shock_tube(1.4, {1, -20, 1, 0}, {1, 20, 1, 0}), ModelError);
  CHECK_THROWS_AS(solve_shock_tube(1.4, {0, 0, 1, 0}, {1, 0, 1, 0}), ModelError);
  CHECK_THROWS_AS(solve_shock_tube(1.4, {1, 0, -1, 0}, {1, 0, 1, 0}), ModelError);
}
