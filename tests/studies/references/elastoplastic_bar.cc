#include "studies/references/elastoplastic_bar.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "mpm/points/errors.h"

using namespace zona::studies::references;
using zona::mpm::ModelError;

namespace {

/// The same bar by explicit finite elements, without Poisson's effect. The load rises over `ramp`
/// elements: a jump would leave oscillations of the mesh that yield where the bar does not.
struct NumericalBar {
  SteppedBar bar;
  int n, ramp;
  std::vector<double> velocity, stress;
  double opening = 0;

  NumericalBar(const SteppedBar& b, int elements, int ramp_elements)
      : bar(b), n(elements), ramp(ramp_elements), velocity(n + 1, 0.0), stress(n, 0.0) {}

  void run_to(double end) {
    const double h = bar.length / n, dt = 0.95 * h / bar.wave_speed();
    const long steps = std::lround(end / dt);
    for (long step = 0; step < steps; ++step) {
      const double load = bar.step * std::min(1.0, 0.95 * (step + 0.5) / ramp);
      for (int i = 0; i <= n; ++i) {
        const double left = i > 0 ? stress[i - 1] : load;
        const double right = i < n ? stress[i] : load;
        const double share = i == 0 || i == n ? 0.5 : 1.0;
        velocity[i] += dt * (right - left) / (share * h * bar.density);
      }
      for (int e = 0; e < n; ++e) {
        const double trial =
            stress[e] + bar.youngs_modulus * dt * (velocity[e + 1] - velocity[e]) / h;
        stress[e] = std::clamp(trial, -bar.yield_stress, bar.yield_stress);
        opening += (trial - stress[e]) / bar.youngs_modulus * h;
      }
    }
  }
  /// Mean magnitude of the error of the stress over the step.
  double stress_error(double time) const {
    double sum = 0;
    for (int e = 0; e < n; ++e) {
      sum += std::abs(stress[e] - free_bar_state(bar, (e + 0.5) / n * bar.length, time).stress);
    }
    return sum / n / bar.step;
  }
};

}  // namespace

TEST_CASE("stress wave in a bar: profiles at 0.25, 0.5 and 0.75 L/c") {
  const auto bar = bar_of_the_source();
  CHECK(bar.wave_speed() == Approx(5062).epsilon(1e-4));
  const double t = bar.transit_time(), z = bar.density * bar.wave_speed();
  const auto stress = [&](double x, double time) { return free_bar_state(bar, x, time).stress; };
  CHECK(stress(2.4, 0.25 * t) == Approx(200e6));
  CHECK(stress(2.6, 0.25 * t) == 0);
  CHECK(stress(7.6, 0.25 * t) == Approx(200e6));
  CHECK(stress(4.9, 0.499 * t) == Approx(200e6));
  CHECK(stress(2.4, 0.75 * t) == Approx(200e6));
  CHECK(stress(2.6, 0.75 * t) == Approx(300e6));
  CHECK(stress(7.4, 0.75 * t) == Approx(300e6));
  CHECK(stress(7.6, 0.75 * t) == Approx(200e6));
  CHECK(free_bar_state(bar, 1, 0.25 * t).velocity == Approx(-200e6 / z));
  CHECK(free_bar_state(bar, 4.9, 0.75 * t).velocity == Approx(-100e6 / z));
  CHECK(free_bar_state(bar, 5.1, 0.75 * t).velocity == Approx(100e6 / z));
  CHECK(mid_section_opening(bar, 0.5 * t) == 0);
  CHECK(mid_section_opening(bar, 0.75 * t) == Approx(0.25 * 200e6 / 72e9 * 10));
}

TEST_CASE("stress wave in a bar: at rest from 1.5 L/c on") {
  const auto bar = bar_of_the_source();
  for (double periods : {1.501, 1.9, 7.3}) {
    for (double x : {0.0, 1.3, 4.99, 5.01, 9.7}) {
      const auto s = free_bar_state(bar, x, periods * bar.transit_time());
      CHECK(s.stress == Approx(200e6));
      CHECK(s.velocity == Approx(0).margin(1e-12));
    }
    CHECK(mid_section_opening(bar, periods * bar.transit_time()) == Approx(200e6 / 72e9 * 10));
  }
}

TEST_CASE("work at the ends is kinetic, stored and dissipated energy at any time") {
  for (double yield : {220e6, 300e6, 390e6, 500e6}) {
    SteppedBar bar = bar_of_the_source();
    bar.yield_stress = yield;
    const double dt = bar.transit_time() / 2000;
    double work = 0;
    for (int step = 0; step < 5100; ++step) {
      const double middle = (step + 0.5) * dt;
      work += bar.step * dt *
              (free_bar_state(bar, bar.length, middle).velocity -
               free_bar_state(bar, 0, middle).velocity);
      if (step % 500 != 499) continue;
      const double now = (step + 1) * dt;
      double energy = yield * mid_section_opening(bar, now);
      const int n = 2000;
      for (int i = 0; i < n; ++i) {
        const auto s = free_bar_state(bar, (i + 0.5) / n * bar.length, now);
        energy += bar.length / n *
                  (s.stress * s.stress / (2 * bar.youngs_modulus) +
                   0.5 * bar.density * s.velocity * s.velocity);
      }
      // Up to two steps of the sum of the work, one cell of the sum of the energy.
      CHECK(energy == Approx(work).epsilon(3e-3).margin(1e-6 * yield));
    }
  }
}

TEST_CASE("finite elements converge to the exact bar") {
  // The ramp is 5 %, then 1.25 % of the length; each front smears the step over it, and what
  // arrives late in the middle is missing there: half a ramp of an L/c of opening at either end.
  const auto bar = bar_of_the_source();
  for (double periods : {0.25, 0.75, 1.25, 1.75, 3.1}) {
    NumericalBar coarse(bar, 401, 20), fine(bar, 1601, 20);
    const double time = periods * bar.transit_time();
    coarse.run_to(time);
    fine.run_to(time);
    CHECK(coarse.stress_error(time) < 0.05);
    CHECK(fine.stress_error(time) < 0.0125);
    const double all = bar.step / bar.youngs_modulus * bar.length;
    CHECK(coarse.opening == Approx(mid_section_opening(bar, time)).margin(0.05 * all));
    CHECK(fine.opening == Approx(mid_section_opening(bar, time)).margin(0.0125 * all));
  }
}

TEST_CASE("elastic limit of the bar: the stress doubles and the bar vibrates without loss") {
  SteppedBar bar = bar_of_the_source();
  bar.yield_stress = 500e6;
  const double t = bar.transit_time();
  CHECK(free_bar_state(bar, 4, 0.75 * t).stress == Approx(400e6));
  CHECK(free_bar_state(bar, 4, 2.75 * t).stress == Approx(400e6));
  CHECK(free_bar_state(bar, 5, 1.75 * t).stress == Approx(0).margin(1));
  CHECK(mid_section_opening(bar, 5 * t) == 0);
}

TEST_CASE("bar with held sides: same equivalent stress, plastic front at c/sqrt(3)") {
  const auto bar = bar_of_the_source();
  const double t = bar.transit_time(), time = 0.75 * t, z = bar.density * bar.wave_speed();
  for (double x = 0.05; x < 10; x += 0.1) {
    CHECK(held_bar_state(bar, x, time).equivalent_stress ==
          Approx(free_bar_state(bar, x, time).equivalent_stress));
  }
  const auto behind = held_bar_state(bar, 5 - 1.44, time),
             ahead = held_bar_state(bar, 5 - 1.45, time);
  CHECK(behind.stress == Approx(357.735e6).epsilon(1e-5));
  CHECK(ahead.stress == Approx(300e6));
  // Jump conditions of the plastic front, speed c/sqrt(3).
  const double speed = bar.wave_speed() / std::sqrt(3.0);
  const double change = behind.stress - ahead.stress;
  CHECK(change == Approx(bar.density * speed * (behind.velocity - ahead.velocity)));
  const double strain = change / bar.youngs_modulus + behind.plastic_strain;
  CHECK((behind.velocity - ahead.velocity) == Approx(speed * strain));
  CHECK(ahead.velocity == Approx(-100e6 / z));
  CHECK_THROWS_AS(held_bar_state(bar, 5, 1.1 * t), ModelError);
}

TEST_CASE("bar: invalid input is refused") {
  SteppedBar bar = bar_of_the_source();
  CHECK_THROWS_AS(free_bar_state(bar, -1, 0), ModelError);
  CHECK_THROWS_AS(free_bar_state(bar, 1, -1), ModelError);
  bar.step = 400e6;
  CHECK_THROWS_AS(free_bar_state(bar, 1, 0), ModelError);
}
