#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "mpm/points/errors.h"
#include "studies/references/inflated_sphere.h"
#include "studies/references/membrane_law.h"
#include "studies/references/membrane_strip.h"
#include "studies/references/sheared_membrane.h"

using namespace zona::studies::references;
using zona::mpm::ModelError;

namespace {

constexpr double young = 17.9e3, nu = 0.49, thickness = 8e-6;

MembraneLaw law_of(StrainMeasure strain, StressMeasure stress,
                   Wrinkling wrinkling = Wrinkling::stress) {
  return {young, nu, thickness, strain, stress, wrinkling};
}

const std::array<MembraneLaw, 4> laws = {
    law_of(StrainMeasure::logarithmic, StressMeasure::kirchhoff),
    law_of(StrainMeasure::biot, StressMeasure::nominal),
    law_of(StrainMeasure::biot, StressMeasure::kirchhoff),
    law_of(StrainMeasure::logarithmic, StressMeasure::nominal)};
const MembraneLaw cut =
    law_of(StrainMeasure::logarithmic, StressMeasure::kirchhoff, Wrinkling::strain);

// Taut, wrinkled along either axis, slack.
const std::array<std::array<double, 2>, 5> stretches = {
    {{1.1, 1.05}, {1.2, 0.85}, {0.8, 1.15}, {0.97, 0.9}, {1.02, 0.995}}};

}  // namespace

TEST_CASE("membrane law: derivatives are those of the tensions") {
  for (const auto& law : {laws[0], laws[1], laws[2], laws[3], cut}) {
    for (const auto& [a, b] : stretches) {
      const auto t = membrane_tensions(law, a, b);
      const double d = 1e-6, scale = young * thickness;
      const auto difference = [&](double da, double db, auto component) {
        return (component(membrane_tensions(law, a + da, b + db)) -
                component(membrane_tensions(law, a - da, b - db))) /
               (2 * d);
      };
      const auto first = [](const MembraneTensions& x) { return x.first; };
      const auto second = [](const MembraneTensions& x) { return x.second; };
      CHECK(std::abs(t.d11 - difference(d, 0, first)) < 1e-8 * scale);  // rounding over d
      CHECK(std::abs(t.d12 - difference(0, d, first)) < 1e-8 * scale);
      CHECK(std::abs(t.d21 - difference(d, 0, second)) < 1e-8 * scale);
      CHECK(std::abs(t.d22 - difference(0, d, second)) < 1e-8 * scale);
    }
  }
}

TEST_CASE("membrane law: conjugate measures derive from the energy, others do not") {
  for (const auto& law : laws) {
    for (const auto& [a, b] : stretches) {
      const auto t = membrane_tensions(law, a, b);
      if (!law.has_energy()) {
        CHECK_THROWS_AS(stored_energy(law, a, b), ModelError);
        if (t.state == MembraneState::taut && a != b) {
          CHECK(std::abs(t.d12 - t.d21) > 1e-3 * std::abs(t.d12));
        }
        continue;
      }
      CHECK(t.d12 == Approx(t.d21).margin(1e-12 * young * thickness));
      const double d = 1e-5;
      const auto slope = [&](double da, double db) {
        return (stored_energy(law, a + da, b + db) - stored_energy(law, a - da, b - db)) / (2 * d);
      };
      CHECK(slope(d, 0) == Approx(t.first).epsilon(1e-6).margin(1e-9 * young * thickness));
      CHECK(slope(0, d) == Approx(t.second).epsilon(1e-6).margin(1e-9 * young * thickness));
    }
  }
}

TEST_CASE("wrinkling is the least energy over contractions that wrinkles take up") {
  // Brute force over wrinkle strains: the elastic strain is at least the geometric one.
  const auto law = laws[0];
  const auto plain = law_of(StrainMeasure::logarithmic, StressMeasure::kirchhoff, Wrinkling::none);
  for (const auto& [a, b] : stretches) {
    double least = stored_energy(plain, a, b);
    for (int i = 0; i <= 1200; ++i) {
      for (int j = 0; j <= 1200; ++j) {
        least = std::min(least,
                         stored_energy(plain, a * std::exp(2.5e-4 * i), b * std::exp(2.5e-4 * j)));
      }
    }
    // The grid of the search misses the minimum by E h (2.5e-4)^2 / 2 or less.
    CHECK(stored_energy(law, a, b) == Approx(least).margin(1e-7 * young * thickness));
  }
}

TEST_CASE("strip: free, held and wrinkled") {
  for (const auto& law : laws) {
    const double e = strain_of(law.strain, 1.03).value;
    const auto free = free_strip(law, 1.03);
    CHECK(free.stress == Approx(young * e));
    CHECK(std::abs(free.lateral_stress) < 1e-10 * young);
    CHECK(strain_of(law.strain, free.lateral_stretch).value == Approx(-nu * e));
    const double share = law.stress == StressMeasure::kirchhoff ? 1.03 : 1;
    CHECK(free.tension == Approx(thickness * young * e / share));
    const auto held = held_strip(law, 1.03, 1);
    CHECK(held.stress == Approx(young * e / (1 - nu * nu)));
    CHECK(held.lateral_stress == Approx(nu * held.stress));
    CHECK(held.state == MembraneState::taut);
    const auto gathered = held_strip(law, 1.03, 0.9);
    CHECK(gathered.state == MembraneState::wrinkled);
    CHECK(gathered.stress == Approx(free.stress));
    CHECK(gathered.tension == Approx(free.tension));
    CHECK(held_strip(law, 0.99, 0.9).state == MembraneState::slack);
  }
  CHECK_THROWS_AS(free_strip(laws[0], 0), ModelError);
  // The source's law: too stiff by 1/(1 - nu^2), and it pulls across, so that no free strip exists.
  const auto gathered = held_strip(cut, 1.03, 0.9);
  CHECK(gathered.stress == Approx(young * std::log(1.03) / (1 - nu * nu)));
  CHECK(gathered.lateral_stress == Approx(nu * gathered.stress));
  CHECK_THROWS_AS(free_strip(cut, 1.03), ModelError);
  CHECK_THROWS_AS(stored_energy(cut, 1.03, 1), ModelError);
}

TEST_CASE("bent strip of Stein and Hedgepeth: onset, band, collapse") {
  const BentStrip strip{1e9, 1e-4, 0.2, 30};
  const double ph = strip.tension * strip.height;
  const double onset = bent_strip(strip, ph / 6).curvature;
  CHECK(onset == Approx(2 * 30 / (1e9 * 0.04 * 1e-4)));
  CHECK(bent_strip(strip, ph / 6).band == 0);
  CHECK(bent_strip(strip, ph / 6 * (1 + 1e-9)).curvature == Approx(onset));
  CHECK(bent_strip(strip, ph / 4).band == Approx(0.25 * strip.height));
  CHECK(bent_strip(strip, ph / 3).band == Approx(0.5 * strip.height));
  CHECK(bent_strip(strip, ph / 3).curvature == Approx(4 * onset));
  for (double m : {0.05, 0.2, 0.45}) {
    const auto s = bent_strip(strip, m * ph);
    CHECK(bent_strip_moment(strip, s.curvature) == Approx(m * ph));
    // Second way: force and moment by summing the one-way law over the section.
    double force = 0, moment = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
      const double from_tensioned_edge = (i + 0.5) / n * strip.height;
      const double stress = std::max(
          0.0, s.largest_stress - strip.youngs_modulus * s.curvature * from_tensioned_edge);
      const double area = strip.thickness * strip.height / n;
      force += stress * area;
      moment += stress * area * (0.5 * strip.height - from_tensioned_edge);
    }
    CHECK(force == Approx(strip.tension).epsilon(1e-7));
    CHECK(moment == Approx(m * ph).epsilon(1e-6));
  }
  CHECK_THROWS_AS(bent_strip(strip, 0.5 * ph), ModelError);
  CHECK_THROWS_AS(bent_strip(strip, -1), ModelError);
}

TEST_CASE("sheared membrane: taut, onset, tension field") {
  const auto law = laws[0];
  const double prestrain = 0.01, onset = wrinkling_shear(law, prestrain);
  CHECK(onset == Approx(2 * 0.01 * 1.49 / 0.51));
  const auto taut = linearly_sheared(law, prestrain, 0.9 * onset);
  CHECK(taut.state == MembraneState::taut);
  CHECK(taut.xy == Approx(young / (2 * 1.49) * 0.9 * onset));
  CHECK(taut.xx == Approx(young / 0.51 * prestrain));
  CHECK(linearly_sheared(law, prestrain, 1.01 * onset).state == MembraneState::wrinkled);
  const auto left = linearly_sheared(law, prestrain, onset * (1 - 1e-9));
  const auto right = linearly_sheared(law, prestrain, onset * (1 + 1e-9));
  CHECK(left.xy == Approx(right.xy).epsilon(1e-7));
  CHECK(left.xx == Approx(right.xx).epsilon(1e-7));
  for (double gamma : {0.02, -0.02}) {
    const auto field = linearly_sheared(law, 0, gamma);
    CHECK(field.xy == Approx(young * gamma / 4));
    CHECK(field.xx == Approx(young * 0.005));
    CHECK(field.yy == Approx(field.xx));
  }
}

TEST_CASE("finite shear tends to the linear one, and its work is the stored energy") {
  const auto law = laws[0];
  for (double prestrain : {0.0, 2e-5}) {
    const double gamma = 1e-4;
    const auto a = finitely_sheared(law, std::exp(prestrain), gamma);
    const auto b = linearly_sheared(law, prestrain, gamma);
    CHECK(a.xx == Approx(b.xx).epsilon(2e-4));  // of the order of gamma
    CHECK(a.xy == Approx(b.xy).epsilon(2e-4));
    CHECK(a.state == b.state);
  }
  // Kirchhoff stress times rate of deformation: dW/dgamma = h tau_xy in simple shear.
  const double d = 1e-5;
  const auto energy = [&](double gamma) {
    const double root = std::sqrt(1 + 0.25 * gamma * gamma), stretch = root + 0.5 * gamma;
    return stored_energy(law, stretch, 1 / stretch);
  };
  for (double gamma : {0.05, 0.4}) {
    CHECK((energy(gamma + d) - energy(gamma - d)) / (2 * d) ==
          Approx(thickness * finitely_sheared(law, 1, gamma).xy).epsilon(1e-7));
  }
}

TEST_CASE("inflated sphere: small strains, greatest pressure, work") {
  const double radius = 30e-6;
  for (const auto& law : laws) {
    const double small = 1e-6;
    CHECK(sphere_pressure(law, radius, 1 + small) ==
          Approx(2 * young * thickness / ((1 - nu) * radius) * small).epsilon(1e-5));
    const double top = sphere_limit_stretch(law), greatest = sphere_pressure(law, radius, top);
    CHECK(sphere_pressure(law, radius, 0.999 * top) < greatest);
    CHECK(sphere_pressure(law, radius, 1.001 * top) < greatest);
    const double p = 0.7 * greatest, stretch = sphere_stretch(law, radius, p);
    CHECK(stretch < top);
    CHECK(sphere_pressure(law, radius, stretch) == Approx(p));
    CHECK_THROWS_AS(sphere_stretch(law, radius, 1.01 * greatest), ModelError);
    if (!law.has_energy()) continue;
    // The work of the pressure is the energy of the membrane.
    double work = 0;
    const int n = 2000;
    for (int i = 0; i < n; ++i) {
      const double a = 1 + 0.3 * (i + 0.5) / n;
      work += sphere_pressure(law, radius, a) * a * a * 0.3 / n;
    }
    CHECK(work * radius == Approx(stored_energy(law, 1.3, 1.3)).epsilon(1e-6));
  }
  CHECK(sphere_limit_stretch(laws[0]) == Approx(std::exp(1.0 / 3)));
  CHECK(sphere_limit_stretch(laws[2]) == Approx(1.5));
  CHECK_THROWS_AS(sphere_pressure(laws[0], radius, 0.9), ModelError);
}
