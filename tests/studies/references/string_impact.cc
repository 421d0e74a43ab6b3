#include "studies/references/string_impact.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mpm/points/errors.h"
#include "studies/references/profile_errors.h"

using namespace zona::studies::references;
using zona::mpm::ModelError;

namespace {

/// Tension [N] in one straight half, the block `drop` below the fixed ends.
double straight_tension(const StringImpact& s, double drop) {
  const double span = 0.5 * (s.length - s.contact_length);
  const double stretch = std::hypot(span, drop) / span;
  double e = std::log(stretch);
  if (s.strain == StringStrain::biot) e = stretch - 1;
  // Tilting alone, with theta the angle: theta sin cos - sin^2 ln cos.
  if (s.strain == StringStrain::summed) {
    const double angle = std::atan2(drop, span), sine = std::sin(angle), cosine = std::cos(angle);
    e = angle * sine * cosine - sine * sine * std::log(cosine);
  }
  const double share = s.stress == StressMeasure::kirchhoff ? stretch : 1;
  return s.area * s.youngs_modulus * e / share;
}

/// Deepest point of a block on a string without mass: all kinetic energy is work on the string.
double deepest_without_waves(const StringImpact& s) {
  const double span = 0.5 * (s.length - s.contact_length);
  double work = 0, drop = 0;
  const double d = 1e-6, all = 0.5 * s.block_mass * s.speed * s.speed;
  while (work < all) {
    const double middle = drop + 0.5 * d;
    work += 2 * straight_tension(s, middle) * middle / std::hypot(span, middle) * d;
    drop += d;
  }
  return -drop;
}

}  // namespace

TEST_CASE("a string hit at constant speed answers with the known waves") {
  // Smith, McCrackin and Schiefer (1958): a linear string, T = E A e, carries a longitudinal wave
  // with c and, behind it at a strain e, a kink with U = c sqrt(e/(1 + e)), both per undeformed
  // length; the geometry of the kink gives V^2 = c^2 (2 e sqrt(e (1 + e)) - e^2).
  StringImpact s = net_of_the_source();
  s.block_mass = 1e9;
  s.contact_length = 0;
  s.strain = StringStrain::biot;
  s.stress = StressMeasure::nominal;
  for (double speed : {1.0, 5.0}) {
    s.speed = speed;
    const double c = 100;
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double e = 0.5 * (low + high);
      (c * c * (2 * e * std::sqrt(e * (1 + e)) - e * e) < speed * speed ? low : high) = e;
    }
    const double kink = c * std::sqrt(low / (1 + low));
    const double force = 2 * s.density * s.area * kink * speed;  // momentum picked up by the kink
    const auto h = string_impact(s, {2000, 4.5e-3, 1e-5, 0.5});
    double mean = 0;
    int count = 0;
    for (const auto& sample : h.samples) {
      if (sample.time < 1e-3) continue;
      mean += sample.contact_force;
      ++count;
    }
    CHECK(mean / count == Approx(force).epsilon(0.01));  // the kink rings over some elements
  }
}

TEST_CASE("a light string is a spring: deepest point and time from its energy") {
  for (auto strain : {StringStrain::biot, StringStrain::logarithmic, StringStrain::summed}) {
    StringImpact s = net_of_the_source();
    s.strain = strain;
    s.density = 2;
    const auto h = string_impact(s, {20, 0.25, 1e-4, 0.5});
    // What the string's own mass, 5 g in 16 kg, and the sampling change.
    CHECK(h.deepest == Approx(deepest_without_waves(s)).epsilon(1e-3));
    // Up as down. The force falls with the cube of the depth: little waves end it a bit early.
    CHECK(h.displacement(2 * h.deepest_time) == Approx(0).margin(0.01 * std::abs(h.deepest)));
    CHECK(h.lift_off_time == Approx(2 * h.deepest_time).epsilon(0.05));
    CHECK(h.samples.back().velocity == Approx(1).epsilon(0.01));
    CHECK(h.energy_error < 1e-3);
  }
}

TEST_CASE("cuboid on the net: momentum, energy, convergence") {
  const auto s = net_of_the_source();
  CHECK(s.block_mass == Approx(16));
  const auto coarse = string_impact(s, {50, 0.2, 1e-3, 0.5});
  const auto middle = string_impact(s, {100, 0.2, 1e-3, 0.5});
  const auto fine = string_impact(s, {200, 0.2, 1e-3, 0.5});
  // Picked up: 1 kg of net, and the half element beyond the edge.
  CHECK(fine.samples[0].velocity == Approx(-16.0 / 17).epsilon(1e-3));
  CHECK(fine.energy_error < 1e-4);  // velocity Verlet keeps the energy to second order
  double first = 0, second = 0;
  for (std::size_t i = 0; i < fine.samples.size(); ++i) {
    first += std::abs(coarse.samples[i].displacement - middle.samples[i].displacement);
    second += std::abs(middle.samples[i].displacement - fine.samples[i].displacement);
  }
  CHECK(first / second > 1.6);  // kinks: about first order
  CHECK(second / fine.samples.size() < 1e-3 * std::abs(fine.deepest));
  CHECK(fine.deepest == Approx(-0.0745).epsilon(2e-3));
  CHECK(fine.deepest_time == Approx(0.113).margin(1.1e-3));
  CHECK(fine.displacement(0.1005) ==
        Approx(0.5 * (fine.displacement(0.1) + fine.displacement(0.101))));
}

TEST_CASE("cuboid on the net: effect of the assumptions") {
  const auto deepest = [](auto change) {
    StringImpact s = net_of_the_source();
    change(s);
    return string_impact(s, {100, 0.2, 1e-3, 0.5}).deepest;
  };
  const double plain = deepest([](StringImpact&) {});
  const double biot = deepest([](StringImpact& s) { s.strain = StringStrain::biot; });
  const double summed = deepest([](StringImpact& s) { s.strain = StringStrain::summed; });
  const double sliding = deepest([](StringImpact& s) { s.contact = StringContact::sliding; });
  const double point = deepest([](StringImpact& s) { s.contact_length = 0; });
  CHECK(biot == Approx(plain).epsilon(5e-3));          // strains of 2 %: e^2 of the measures
  CHECK(summed / plain == Approx(0.84).margin(0.01));  // twice the strain, 2^(-1/4)
  CHECK(sliding < plain);
  CHECK(point < sliding);
}

TEST_CASE("string: invalid input is refused") {
  auto s = net_of_the_source();
  s.contact_length = 1;
  CHECK_THROWS_AS(string_impact(s), ModelError);
  s = net_of_the_source();
  s.density = -1;
  CHECK_THROWS_AS(string_impact(s), ModelError);
  s = net_of_the_source();
  CHECK_THROWS_AS(string_impact(s, {100, 0.2, 1e-3, 1.5}), ModelError);
  CHECK_THROWS_AS(string_impact(s, {10, 0.01, 1e-3, 0.5}).displacement(0.02), ModelError);
}
