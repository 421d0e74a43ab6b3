#include "studies/references/fluid_flows.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "mpm/points/errors.h"

using namespace zona::studies::references;
using zona::mpm::ModelError;

namespace {

const SuddenWall water{8.9e-4, 1000, 0.01};
constexpr double pi = 3.14159265358979323846;

/// Residual of u_t = nu u_yy by central differences, over the size of u_t.
template <class F>
double diffusion_residual(const F& u, double y, double t, double nu, double dy, double dt) {
  const double rate = (u(y, t + dt) - u(y, t - dt)) / (2 * dt);
  const double bend = (u(y + dy, t) - 2 * u(y, t) + u(y - dy, t)) / (dy * dy);
  return std::abs(rate - nu * bend) / std::abs(rate);
}

}  // namespace

TEST_CASE("Stokes' first problem: equation, boundary values, momentum") {
  const auto u = [](double y, double t) { return sudden_wall_velocity(water, y, t); };
  const double nu = water.kinematic_viscosity(), t = 0.3;
  CHECK(u(0, t) == Approx(water.speed));
  CHECK(u(1e-4, 0) == 0);
  CHECK(u(std::sqrt(4 * nu * t), t) == Approx(0.157299 * water.speed).epsilon(1e-5));  // erfc(1)
  CHECK(diffusion_residual(u, 3e-4, t, nu, 1e-6, 1e-4) < 1e-4);  // differences of second order
  // The momentum of the fluid is what the wall's stress brought in: the integral of tau over t.
  double momentum = 0;
  for (double y = 5e-7; y < 5e-3; y += 1e-6) momentum += 1e-6 * water.density * u(y, t);
  CHECK(momentum == Approx(2 * t * sudden_wall_stress(water, t)).epsilon(1e-5));
  CHECK_THROWS_AS(sudden_wall_stress(water, 0), ModelError);
  CHECK_THROWS_AS(u(-1, t), ModelError);
}

TEST_CASE("Couette start-up: images and modes agree, limits") {
  const double gap = 1e-3, nu = water.kinematic_viscosity();
  const double change = 0.1 * gap * gap / nu;
  for (double y : {0.0, 1e-4, 5e-4, 9e-4, 1e-3}) {
    const double before = couette_velocity(water, gap, y, change * (1 - 1e-12));
    const double after = couette_velocity(water, gap, y, change * (1 + 1e-12));
    CHECK(before == Approx(after).epsilon(1e-9).margin(1e-13));
    CHECK(couette_velocity(water, gap, y, 100 * change) ==
          Approx(water.speed * (1 - y / gap)).margin(1e-13));
    CHECK(couette_velocity(water, gap, y, 1e-2 * change) ==
          Approx(sudden_wall_velocity(water, y, 1e-2 * change)).margin(1e-13));
  }
  const auto u = [&](double y, double t) { return couette_velocity(water, gap, y, t); };
  for (double t : {0.5 * change, 2 * change}) {
    CHECK(diffusion_residual(u, 4e-4, t, nu, 1e-6, 1e-4 * change) < 1e-4);
  }
}

TEST_CASE("standing wave: frequency, decay, equations of motion") {
  const StandingWave wave{1500, 1000, 200, 0.1, 2, 0.01};
  const double k = wave.wave_number();
  CHECK(k == Approx(2 * pi / 0.1));
  CHECK(wave.decay_rate() == Approx(4.0 / 3 * 200 / (2 * 1000) * k * k));
  const double omega = wave.angular_frequency();
  CHECK(omega == Approx(std::sqrt(1500 * 1500 * k * k - std::pow(wave.decay_rate(), 2))));

  const double period = 2 * pi / omega;
  CHECK(standing_wave(wave, 0.03, period).velocity / standing_wave(wave, 0.03, 0).velocity ==
        Approx(std::exp(-wave.decay_rate() * period)));
  CHECK(standing_wave(wave, 0.0, 0.3 * period).velocity == 0);
  CHECK(standing_wave(wave, 0.1, 0.3 * period).velocity == Approx(0).margin(1e-15));

  // rho v_t = -p_x + 4/3 mu v_xx and p_t = -rho c^2 v_x, by central differences of second order.
  const double x = 0.013, t = 0.21 * period, dx = 1e-5, dt = 1e-4 * period;
  const auto at = [&](double place, double time) { return standing_wave(wave, place, time); };
  const double acceleration = (at(x, t + dt).velocity - at(x, t - dt).velocity) / (2 * dt);
  const double slope = (at(x + dx, t).pressure - at(x - dx, t).pressure) / (2 * dx);
  const double bend =
      (at(x + dx, t).velocity - 2 * at(x, t).velocity + at(x - dx, t).velocity) / (dx * dx);
  CHECK(1000 * acceleration == Approx(-slope + 4.0 / 3 * 200 * bend).epsilon(1e-5));
  const double pressure_rate = (at(x, t + dt).pressure - at(x, t - dt).pressure) / (2 * dt);
  const double strain_rate = (at(x + dx, t).velocity - at(x - dx, t).velocity) / (2 * dx);
  CHECK(pressure_rate == Approx(-1000 * 1500.0 * 1500.0 * strain_rate).epsilon(1e-5));
}

TEST_CASE("standing wave without viscosity keeps its energy; an overdamped one is refused") {
  StandingWave wave{1500, 1000, 0, 0.1, 1, 0.01};
  const auto energy = [&](double t) {
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
      const auto s = standing_wave(wave, (i + 0.5) * 1e-4, t);
      sum += 0.5 * 1000 * s.velocity * s.velocity +
             0.5 * s.pressure * s.pressure / (1000 * 1500.0 * 1500.0);
    }
    return sum;
  };
  CHECK(energy(1.7e-5) == Approx(energy(0)).epsilon(1e-12));
  wave.viscosity = 1e9;
  CHECK_THROWS_AS(standing_wave(wave, 0.01, 0), ModelError);
}

TEST_CASE("free fall") {
  const auto f = free_fall(2, 1, 9.81, 0.5);
  CHECK(f.position == Approx(2 + 0.5 - 9.81 / 8));
  CHECK(f.velocity == Approx(1 - 9.81 / 2));
}
