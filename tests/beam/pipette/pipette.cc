#include "beam/pipette/pipette.h"

#include <catch2/catch.hpp>

#include "beam/pipette/fluid.h"
#include "beam/system/beam_system.h"
#include "beam/time/integrate.h"
#include "tests/beam/cases.h"

using namespace zona::beam;
using Catch::Matchers::Contains;

TEST_CASE("the default pipette full of mercury has the properties of Table 5.5") {
  const UniformBeam beam = uniform_beam(test::pipette_with("mercury"));
  // Half a unit of the last digit printed; the rigidity is printed as 183.86, the modulus as 63.44.
  CHECK(beam.flexural_rigidity == Approx(183.86e-13).epsilon(1e-4));
  CHECK(beam.mass_per_length == Approx(7.486e-7).margin(0.0005e-7));
}

TEST_CASE("the matrices give the total mass and the rigid motion") {
  const Pipette pipette = test::pipette_with("water", 7);
  const UniformBeam beam = uniform_beam(pipette);
  const BeamSystem system = cantilever(pipette);
  // A rigid translation of the free vertices lacks only the share of the clamped vertex:
  // rho l - (13/35 + 9/70) rho h, the exact integral of the left Hermite deflection function.
  double mass = 0;
  for (int i = 0; i < system.size(); ++i)
    if (!system.rotation[i]) mass += system.support_mass(i);
  const double expected = beam.mass_per_length * (beam.length - system.element_length / 2);
  CHECK(mass == Approx(expected).epsilon(1e-13));
}

TEST_CASE("the static tip deflection under a tip force is exact") {
  const Pipette pipette = test::pipette_with("none", 5);
  const UniformBeam beam = uniform_beam(pipette);
  const BeamSystem system = cantilever(pipette);
  Eigen::VectorXd deflection = 1e-9 * system.observation;
  BandFactor(system.stiffness).solve_in_place(deflection);
  // F l^3 / (3 EI): cubic, so in the element space. Rounding grows with the condition, here about
  // 1e6.
  const double exact = 1e-9 * std::pow(beam.length, 3) / (3 * beam.flexural_rigidity);
  CHECK(system.observation.dot(deflection) == Approx(exact).epsilon(1e-9));
}

TEST_CASE("an impossible pipette is refused with the value, the limit and the remedy") {
  const auto refuse = [](auto change, const char* first, const char* second) {
    Pipette pipette;
    change(pipette);
    CHECK_THROWS_AS(check(pipette), std::invalid_argument);
    CHECK_THROWS_WITH(cantilever(pipette), Contains(first) && Contains(second));
  };
  refuse([](Pipette& p) { p.length = -1; }, "length is -1 m", "greater than 0");
  refuse([](Pipette& p) { p.inner_diameter = 11e-6; }, "inner_diameter is 1.1e-05", "1e-05 m");
  refuse([](Pipette& p) { p.length = 50e-6; }, "Euler-Bernoulli", "0.0001 m");
  refuse([](Pipette& p) { p.youngs_modulus = NAN; }, "youngs_modulus is nan", "greater than 0");
  refuse([](Pipette& p) { p.fill_density = -1; }, "fill_density is -1", "at least 0");
  refuse([](Pipette& p) { p.density = 0; }, "density is 0", "greater than 0");
  refuse([](Pipette& p) { p.elements = 0; }, "elements is 0", "between 1 and");
  refuse([](Pipette& p) { p.damping_beta = -1; }, "damping_beta is -1", "at least 0");
}

TEST_CASE("named fluids are those of Table 5.7 and others, by increasing density") {
  CHECK(named_fluid("none").density == 0);
  CHECK(named_fluid("water").density == 1000);
  CHECK(named_fluid("fluorinert").density == 1780);
  CHECK(named_fluid("mercury").density == 13600);
  for (std::size_t i = 1; i < named_fluids().size(); ++i) {
    CHECK(named_fluids()[i - 1].density <= named_fluids()[i].density);
    CHECK_FALSE(named_fluids()[i].source.empty());
  }
  CHECK_THROWS_WITH(named_fluid("mercry"), Contains("'mercry'") && Contains("mercury"));
}

TEST_CASE("invalid support motions and runs are refused") {
  const BeamSystem system = cantilever(Pipette{});
  const auto pulse = triangular_pulse(1e-6, 60e-6);
  CHECK_THROWS_WITH(triangular_pulse(1e-6, 0), Contains("duration is 0"));
  CHECK_THROWS_WITH(check(SampledMotion{{0, 1, 1}, {0, 1, 2}}), Contains("sample 2"));
  CHECK_THROWS_WITH(check(SampledMotion{{0, 1}, {1, 2}}), Contains("begin with displacement 0"));
  CHECK_THROWS_WITH(check(SampledMotion{{0, 1}, {0, NAN}}), Contains("sample 1"));
  CHECK_THROWS_WITH(check(SampledMotion{{0}, {0}}), Contains("at least 2"));
  CHECK_THROWS_WITH(check(SineMotion{1e-6, 0}), Contains("greater than 0"));
  CHECK_THROWS_WITH(integrate(system, pulse, {1e-3, 0}, Newmark{}), Contains("step of 0 s"));
  CHECK_THROWS_WITH(integrate(system, pulse, {1e3, 1e-9}, Newmark{}), Contains("longer step"));
  CHECK_THROWS_WITH(integrate(system, pulse, {}, Newmark{0}), Contains("at least 1"));
  CHECK_THROWS_WITH(integrate(system, pulse, {}, Modal{41}), Contains("this mesh has 40"));
  CHECK_THROWS_WITH(integrate(system, pulse, {}, Arkode{-1}), Contains("greater than 0"));
  CHECK_THROWS_WITH(amplitude_ratio(TipHistory{}, 0), Contains("not 0"));
  CHECK_THROWS_WITH(assemble({1, [](double) { return 1.; }, [](double x) { return x - 0.5; }},
                             {4, Supports::clamped_free, 1}),
                    Contains("mass"));
}

TEST_CASE("a pulse is straight between its kinks") {
  const auto pulse = triangular_pulse(2e-6, 60e-6);
  CHECK(displacement(pulse, 0) == 0);
  CHECK(displacement(pulse, 15e-6) == Approx(1e-6));
  CHECK(displacement(pulse, 30e-6) == Approx(2e-6));
  CHECK(displacement(pulse, 45e-6) == Approx(1e-6));
  CHECK(displacement(pulse, 1) == 0);
  CHECK(velocity(pulse, 0) == Approx(2e-6 / 30e-6));
  CHECK(velocity(pulse, 30e-6) == Approx(-2e-6 / 30e-6));
  CHECK(velocity(pulse, 60e-6) == 0);
  CHECK(peak_displacement(pulse) == 2e-6);
  const auto all = kinks(pulse);
  REQUIRE(all.size() == 3);
  CHECK(all[0].velocity_jump == Approx(2e-6 / 30e-6));
  CHECK(all[1].velocity_jump == Approx(-4e-6 / 30e-6));
  CHECK(all[2].velocity_jump == Approx(2e-6 / 30e-6));
}
