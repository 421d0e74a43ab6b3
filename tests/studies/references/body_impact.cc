#include "studies/references/body_impact.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "mpm/points/errors.h"

using namespace zona::studies::references;
using zona::mpm::ModelError;

TEST_CASE("plateau of aluminium on steel") {
  const auto impact = impact_of_the_source();
  // (lambda + 2 mu) = E (1 - nu)/((1 + nu)(1 - 2 nu)), by hand.
  CHECK(impact.projectile.wave_speed() == Approx(6197.9).epsilon(1e-4));
  CHECK(impact.target.wave_speed() == Approx(5875.0).epsilon(1e-4));
  const auto plateau = impact_plateau(impact, ImpactSide::target);
  CHECK(plateau.stress == Approx(-122.58e6).epsilon(1e-4));
  CHECK(plateau.lateral_stress == Approx(3.0 / 7 * plateau.stress));
  // Jump conditions of both fronts: stress = -Z (change of velocity).
  CHECK(plateau.stress == Approx(-impact.target.impedance() * plateau.velocity));
  CHECK(plateau.stress == Approx(-impact.projectile.impedance() * (10 - plateau.velocity)));
}

TEST_CASE("impact of equal bodies: half the speed, exchange of momentum at the end") {
  const ImpactBody steel{2e11, 0.3, 7800, 0.1};
  const BodyImpact impact{steel, steel, 10, 0.3};
  const double end = 2 * steel.width / steel.wave_speed() * (1 - 1e-9);
  CHECK(impact_plateau(impact, ImpactSide::target).velocity == Approx(5));
  CHECK(impact_state(impact, ImpactSide::target, 0.05, end).velocity == Approx(10));
  CHECK(impact_state(impact, ImpactSide::projectile, 0.05, end).velocity == Approx(0).margin(1e-9));
}

TEST_CASE("impact conserves momentum and energy in one-dimensional strain") {
  const auto impact = impact_of_the_source();
  for (double time : {3e-6, 1.5e-5, 2e-5, 3e-5}) {
    double momentum = 0, energy = 0;
    const int n = 20000;
    for (auto side : {ImpactSide::projectile, ImpactSide::target}) {
      const ImpactBody& body = side == ImpactSide::target ? impact.target : impact.projectile;
      const double modulus = body.density * body.wave_speed() * body.wave_speed();
      for (int i = 0; i < n; ++i) {
        const auto s = impact_state(impact, side, (i + 0.5) / n * body.width, time);
        momentum += body.width / n * body.density * s.velocity;
        energy += body.width / n * 0.5 *
                  (body.density * s.velocity * s.velocity + s.stress * s.stress / modulus);
      }
    }
    CHECK(momentum == Approx(0.1 * 2700 * 10).epsilon(1e-4));  // a cell of the sum
    CHECK(energy == Approx(0.1 * 0.5 * 2700 * 100).epsilon(1e-4));
  }
}

TEST_CASE("the window at a point ends with the first release") {
  const auto impact = impact_of_the_source();
  const double c1 = impact.projectile.wave_speed(), c2 = impact.target.wave_speed();
  SECTION("in the faster body the straight way is the first") {
    const auto w = impact_window(impact, ImpactSide::projectile, 0.025, 0.15);
    CHECK(w.arrival == Approx(0.025 / c1));
    CHECK(w.lateral_release == Approx(std::hypot(0.025, 0.15) / c1));
    CHECK(w.rear_release == Approx(0.175 / c1));
    CHECK(w.end() == w.lateral_release);
  }
  SECTION("in the slower body the first way is the least over all that run along the contact") {
    for (double distance : {0.0, 0.01, 0.025, 0.08}) {
      double least = 1;
      for (int i = 0; i <= 100000; ++i) {
        const double along = 0.15 * i / 100000;
        least = std::min(least, along / c1 + std::hypot(0.15 - along, distance) / c2);
      }
      const auto w = impact_window(impact, ImpactSide::target, distance, 0.15);
      CHECK(w.lateral_release == Approx(least).epsilon(1e-8));
    }
  }
  SECTION("far inside the rear face is the nearer boundary") {
    const auto w = impact_window(impact, ImpactSide::target, 0.1, 0.15);
    CHECK(w.end() == Approx(0.1 / c2));
  }
  SECTION("point A") {
    const ImpactProbe a;
    const auto w = impact_window(impact, a.side, a.distance, 0.5 * impact.height);
    CHECK(w.arrival == Approx(4.255e-6).epsilon(1e-3));
    CHECK(w.lateral_release == Approx(25.56e-6).epsilon(1e-3));
    CHECK(w.rear_release == Approx(29.79e-6).epsilon(1e-3));
  }
}

TEST_CASE("impact: points and times outside are refused") {
  const auto impact = impact_of_the_source();
  CHECK_THROWS_AS(impact_state(impact, ImpactSide::target, 0.11, 1e-6), ModelError);
  CHECK_THROWS_AS(impact_state(impact, ImpactSide::target, 0.01, 3.3e-5), ModelError);
  CHECK_THROWS_AS(impact_window(impact, ImpactSide::target, 0.01, 0.2), ModelError);
  BodyImpact wrong = impact;
  wrong.target.poisson_ratio = 0.5;
  CHECK_THROWS_AS(impact_plateau(wrong, ImpactSide::target), ModelError);
}
