#include "mpm/bodies/single_point.h"

#include <catch2/catch.hpp>

#include "mpm/bodies/mixed_control.h"
#include "mpm/points/errors.h"

using namespace zona::mpm;

namespace {

const ElasticModuli stiff{200e9, 0.3};
const ElasticModuli soft{17.9e3, 0.49};
const VonMises softening{300e6, 350e6, 10e9, 5e9, {}};

constexpr FreeComponents lateral{false, true, true, false, false, false};

}  // namespace

TEST_CASE("A free elastic bar contracts by Poisson's ratio and keeps no stress across") {
  SinglePoint bar(stiff, Elastic{});
  const double left = step_to(bar, {1e-3, 0, 0, 0, 0, 0}, lateral);
  const PointSample s = bar.sample();
  CHECK(s.stress[0] == Approx(200e6).epsilon(1e-9));
  CHECK(s.strain[1] == Approx(-3e-4).epsilon(1e-9));
  CHECK(s.strain[2] == Approx(-3e-4).epsilon(1e-9));
  CHECK(left < 1e-14 * 200e9 * 1e-3 * 100);
  CHECK(s.stored_energy == Approx(0.5 * 200e6 * 1e-3));
}

TEST_CASE("Uniaxial stress of a von Mises bar: slopes E, E h/(E + h) by the plastic path length") {
  SinglePoint bar(stiff, softening);
  // Along the bar d eps_p = sqrt(2/3) dI: the strength's slope over plastic strain is sqrt(3/2) of
  // its modulus.
  const double at_yield = 300e6 / 200e9;
  const double at_peak = 350e6 / 200e9 + std::sqrt(2.0 / 3) * softening.peak_strain();
  for (int step = 1; step <= 800; ++step) {
    const double e = 1e-4 * step;
    const double left = step_to(bar, {e, 0, 0, 0, 0, 0}, lateral);
    REQUIRE(left < 1e-12 * 350e6);
    double exact = 200e9 * e;
    const auto slope = [](double h) { return 200e9 * h / (200e9 + h); };
    if (e > at_yield) exact = 300e6 + slope(std::sqrt(1.5) * 10e9) * (e - at_yield);
    if (e > at_peak) exact = 350e6 + slope(-std::sqrt(1.5) * 5e9) * (e - at_peak);
    REQUIRE(bar.sample().stress[0] == Approx(std::max(0.0, exact)).epsilon(1e-9).margin(1));
  }
}

TEST_CASE("A solid that is free through its thickness is a membrane without its one-way law") {
  const MembraneProperties sheet{1000, 1, 200e9, 0.3, OneWay::off};
  const FreeComponents out_of_plane{false, false, true, false, true, true};
  SinglePoint solid(stiff, softening), membrane(sheet, softening);
  for (int step = 1; step <= 100; ++step) {
    const SymmetricTensor target{2e-4 * step, -5e-5 * step, 0, 8e-5 * step, 0, 0};
    const double left = step_to(solid, target, out_of_plane);
    step_to(membrane, target, {});
    const PointSample a = solid.sample(), b = membrane.sample();
    CHECK(left < 1e-12 * 350e6);
    for (int c : {0, 1, 3}) CHECK(a.stress[c] == Approx(b.stress[c]).margin(1e-8 * 300e6));
    CHECK(a.internal == Approx(b.internal).margin(1e-10));
  }
  CHECK(solid.sample().internal > softening.peak_strain());
}

TEST_CASE("Plane stress localises where the membrane does, a free solid in three dimensions") {
  VonMises law{1062.795, 1062.805, 17.9, 179e3, Decohesion{}};
  law.decohesion->cell.setConstant(2e-8);
  SinglePoint solid(soft, law);
  SinglePoint membrane(MembraneProperties{1000, 1, 17.9e3, 0.49, OneWay::stress}, law);
  for (int step = 1; step <= 700; ++step) {
    step_to(solid, {1e-4 * step, 0, 0, 0, 0, 0}, {false, true, true, true, true, true});
    step_to(membrane, {1e-4 * step, 0, 0, 0, 0, 0}, {false, true, false, true, false, false});
  }
  CHECK(std::abs(solid.sample().normal.x()) == Approx(std::cos(0.78206)).epsilon(1e-3));
  CHECK(std::abs(membrane.sample().normal.x()) == Approx(std::sqrt(2.0 / 3)).epsilon(1e-3));
  for (const SinglePoint* point : {&solid, &membrane}) {
    const PointSample s = point->sample();
    CHECK(s.left > 0);
    CHECK(s.left < 1);
    CHECK(s.opening_dissipation > 0);
    CHECK(s.opening_dissipation < s.resolved_energy);
    CHECK(s.effective_length == Approx(2e-8).epsilon(0.3));
  }
}

TEST_CASE("A wrinkled or failed membrane keeps its free strain") {
  SinglePoint strip(MembraneProperties{1000, 1, 17.9e3, 0.49, OneWay::stress}, Elastodamage{});
  for (int step = 1; step <= 700; ++step) {
    CHECK(step_to(strip, {1e-4 * step, 0, 0, 0, 0, 0}, {false, true, false, true, false, false}) <
          1e-10);
    CHECK(std::abs(strip.sample().strain[1]) < 0.03);
  }
  CHECK(strip.sample().left == 0);
}

TEST_CASE("Invalid points are refused") {
  CHECK_THROWS_AS(SinglePoint(ElasticModuli{1, 0.5}, Elastic{}), ModelError);
  CHECK_THROWS_AS(SinglePoint(stiff, VonMises{}), ModelError);
  CHECK_THROWS_AS(SinglePoint(MembraneProperties{1000, 1, 1, 0.3, OneWay::off}, VonMises{}),
                  ModelError);
}
