#include "studies/references/indented_egg.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mpm/points/errors.h"

using namespace zona::studies::references;
using Eigen::Vector2d;
using zona::mpm::ModelError;

namespace {

constexpr double pi = 3.14159265358979323846;

double displacement(const IndentedEgg& egg, double force, int elements = 100) {
  return indent_egg(egg, {force}, elements).back().displacement;
}

/// Undeformed and current middle, tangent and stretches of an element.
struct Place {
  double undeformed_radius, radius, length;
  Vector2d tangent;
  MembraneTensions tension;
};
Place place(const IndentedEggState& s, const MembraneLaw& law, int e) {
  const auto &home = s.reference, &x = s.shape.position;
  const Vector2d old_span = home.segment<2>(2 * e + 2) - home.segment<2>(2 * e);
  const Vector2d span = x.segment<2>(2 * e + 2) - x.segment<2>(2 * e);
  const double undeformed = 0.5 * (home[2 * e] + home[2 * e + 2]);
  const double radius = 0.5 * (x[2 * e] + x[2 * e + 2]);
  return {undeformed, radius, old_span.norm(), span.normalized(),
          membrane_tensions(law, span.norm() / old_span.norm(), radius / undeformed)};
}

}  // namespace

TEST_CASE("egg: the computed shape satisfies the membrane's differential equations") {
  const auto egg = egg_of_the_source();
  const int elements = 400;
  const auto s = indent_egg(egg, {0.2e-6}, elements).back();
  const double scale = egg.membrane.youngs_modulus * egg.membrane.thickness;
  int checked = 0;
  for (int e = 5; e + 5 < elements; ++e) {
    const auto& x = s.shape.position;
    if (x[2 * e - 7] < 1e-7) continue;  // on the plate
    const Place at = place(s, egg.membrane, e);
    // Vertical: everything above a latitude; 2 pi R P t_z = p pi r^2 - F.
    const double pull = 2 * pi * at.undeformed_radius * at.tension.first * at.tangent[1];
    const double push = s.pressure * pi * at.radius * at.radius - s.force;
    CHECK(std::abs(pull - push) < 3e-3 * s.force);  // elements are straight: second order
    // Radial: d(R P t_r)/dS - P_around + p r (l/L) t_z = 0, over four elements.
    const Place a = place(s, egg.membrane, e - 2), b = place(s, egg.membrane, e + 2);
    double distance = 0.5 * (a.length + b.length);
    for (int k = e - 1; k <= e + 1; ++k) distance += place(s, egg.membrane, k).length;
    const double change = (b.undeformed_radius * b.tension.first * b.tangent[0] -
                           a.undeformed_radius * a.tension.first * a.tangent[0]) /
                          distance;
    const double stretch = (x.segment<2>(2 * e + 2) - x.segment<2>(2 * e)).norm() / at.length;
    const double residual =
        change - at.tension.second + s.pressure * at.radius * stretch * at.tangent[1];
    CHECK(std::abs(residual) < 3e-3 * scale);
    ++checked;
  }
  CHECK(checked > 200);
}

TEST_CASE("egg: the work of the force is the stored energy") {
  const auto egg = egg_of_the_source();
  std::vector<double> forces;
  for (int i = 1; i <= 30; ++i) forces.push_back(0.5e-6 * std::pow(i / 30.0, 3));
  const auto states = indent_egg(egg, forces, 100);
  // From the first state on, by the trapezoidal rule.
  double work = states[0].strain_energy;
  for (std::size_t i = 1; i < states.size(); ++i) {
    work += 0.5 * (states[i].force + states[i - 1].force) *
            (states[i].displacement - states[i - 1].displacement);
    CHECK(states[i].displacement > states[i - 1].displacement);
  }
  CHECK(states.back().strain_energy == Approx(work).epsilon(5e-3));
}

TEST_CASE("egg of 5.2: converged displacement, far above the source's") {
  const auto egg = egg_of_the_source();
  const double coarse = displacement(egg, 0.5e-6, 50), middle = displacement(egg, 0.5e-6, 100),
               fine = displacement(egg, 0.5e-6, 200);
  CHECK(std::abs(fine - middle) < 0.7 * std::abs(middle - coarse));
  CHECK(fine == Approx(30.43e-6).epsilon(2e-3));
  // What 7.466 um takes: a force 33 times smaller.
  CHECK(displacement(egg, 0.015e-6, 200) == Approx(7.42e-6).epsilon(5e-3));
  // Forces scale with E h.
  IndentedEgg stiff = egg;
  stiff.membrane.youngs_modulus *= 2;
  CHECK(displacement(stiff, 0.5e-6) == Approx(displacement(egg, 0.25e-6)).epsilon(1e-6));
}

TEST_CASE("egg: P_inf has no influence") {
  IndentedEgg egg = egg_of_the_source();
  egg.bulk_modulus = stiffened_gas_bulk_modulus(4, 2.1e8);
  const auto soft = indent_egg(egg, {0.5e-6}, 100).back();
  egg.bulk_modulus = stiffened_gas_bulk_modulus(4, 2.4e8);
  const auto hard = indent_egg(egg, {0.5e-6}, 100).back();
  CHECK(egg.bulk_modulus == Approx(1.2e9));
  CHECK(soft.volume_change == Approx(-459 / 1.05e9).epsilon(0.01));
  CHECK(hard.displacement == Approx(soft.displacement).epsilon(1e-6));
}

TEST_CASE("egg: support, pipette, measures") {
  const double force = 0.5e-6, plain = displacement(egg_of_the_source(), force);
  const auto with = [&](auto change) {
    IndentedEgg egg = egg_of_the_source();
    change(egg);
    return displacement(egg, force) / plain;
  };
  CHECK(with([](IndentedEgg& e) { e.support = EggSupport::sticking_plate; }) ==
        Approx(0.995).margin(0.01));
  // The lower half held: as stiff as a support can make it.
  CHECK(with([](IndentedEgg& e) {
          e.support = EggSupport::held;
          e.support_radius = 29e-6;
        }) == Approx(0.64).margin(0.01));
  CHECK(with([](IndentedEgg& e) {
          e.pipette_outer = 6e-6;
          e.pipette_inner = 0;
        }) == Approx(0.90).margin(0.01));
  CHECK(with([](IndentedEgg& e) { e.membrane.strain = StrainMeasure::biot; }) ==
        Approx(0.976).margin(0.01));
  CHECK(with([](IndentedEgg& e) { e.membrane.wrinkling = Wrinkling::none; }) ==
        Approx(0.994).margin(0.01));
  CHECK(with([](IndentedEgg& e) { e.summed = true; }) == Approx(0.79).margin(0.01));
}

TEST_CASE("egg: invalid input is refused") {
  IndentedEgg egg = egg_of_the_source();
  CHECK_THROWS_AS(indent_egg(egg, {}), ModelError);
  CHECK_THROWS_AS(indent_egg(egg, {2e-7, 1e-7}), ModelError);
  CHECK_THROWS_AS(indent_egg(egg, {1e-7}, 5), ModelError);
  egg.pipette_inner = 4e-6;
  CHECK_THROWS_AS(indent_egg(egg, {1e-7}), ModelError);
  egg = egg_of_the_source();
  egg.support = EggSupport::held;
  CHECK_THROWS_AS(indent_egg(egg, {1e-7}), ModelError);
  egg = egg_of_the_source();
  egg.bulk_modulus = -1;
  CHECK_THROWS_AS(indent_egg(egg, {1e-7}), ModelError);
}
