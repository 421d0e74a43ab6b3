#include <catch2/catch.hpp>
#include <cmath>

#include "beam/exact/transfer.h"
#include "beam/frequency/transfer_function.h"
#include "beam/system/natural_modes.h"
#include "beam/time/modal_stepper.h"
#include "tests/beam/cases.h"

using namespace zona::beam;

TEST_CASE("a solid cone vibrates with its known frequencies") {
  // Clamped at its base, with its point free: omega L^2 sqrt(rho A0/(E I0)) of Bessel functions.
  constexpr double length = 1;
  Section cone;
  cone.length = length;
  cone.mass_per_length = [](double x) { return std::pow(1 - x / length, 2); };
  cone.flexural_rigidity = [](double x) { return std::pow(1 - x / length, 4); };
  double coarse = 0;
  for (const int elements : {40, 80}) {
    const NaturalModes modes = natural_modes(assemble(cone, {elements, Supports::clamped_free, 1}));
    const double error = std::abs(modes.angular_frequency(2) / 38.4538 - 1);
    if (elements == 80) {
      CHECK(modes.angular_frequency(0) == Approx(8.7193).epsilon(1e-5));
      CHECK(modes.angular_frequency(1) == Approx(21.1457).epsilon(2e-5));
      CHECK(modes.angular_frequency(2) == Approx(38.4538).epsilon(1e-4));
      CHECK(error < coarse);
    }
    coarse = error;
  }
}

TEST_CASE("a constant profile equals the uniform pipette") {
  const Pipette uniform = test::pipette_with("mercury", 40);
  Pipette profiled = uniform;
  profiled.profile = {{0, 10e-6, 8e-6}, {4e-3, 10e-6, 8e-6}, {10e-3, 10e-6, 8e-6}};
  CHECK(diameters_at(profiled, 2e-3).outer == 10e-6);
  const Eigen::VectorXd one = natural_modes(cantilever(uniform)).frequency();
  const Eigen::VectorXd other = natural_modes(cantilever(profiled)).frequency();
  CHECK((one.head(10) - other.head(10)).norm() < 1e-9 * one(9));
}

TEST_CASE("columns of fluid have the frequencies of a beam in pieces") {
  Pipette pipette = test::pipette_with("none", 80);
  pipette.columns = {{1.3e-3, 4.1e-3, 13600}};
  const BeamSystem system = cantilever(pipette);
  const TransferFunction transfer(system);
  const Pipette full = test::pipette_with("mercury");
  const Pipette empty = test::pipette_with("none");
  const double rigidity = pipette.youngs_modulus * second_moment_of_area(pipette);
  const std::vector<UniformPiece> pieces{{5.9e-3, rigidity, mass_per_length(empty), 0},
                                         {2.8e-3, rigidity, mass_per_length(full), 0},
                                         {1.3e-3, rigidity, mass_per_length(empty), 0}};
  for (const double frequency : {50., 500., 5000.}) {
    const std::complex<double> s(100, 2 * M_PI * frequency);
    CHECK(std::abs(transfer(s) / exact_transfer(pieces, {}, s) - 1.) < 1e-3);
  }
}

TEST_CASE("the load on a tapering pipette is that of many short cylinders") {
  Pipette pipette = test::pipette_with("water", 100);
  pipette.profile = {{0, 10e-6, 8e-6}, {10e-3, 200e-6, 160e-6}};
  pipette.bath.model = BathModel::frequency;
  pipette.bath.immersed_length = 6e-3;
  const BeamSystem system = cantilever(pipette);
  double coarse = 0;
  for (const int count : {100, 200}) {
    std::vector<UniformPiece> pieces;
    for (int i = 0; i < count; ++i) {
      const double x = pipette.length * (i + 0.5) / count;
      const Diameters d = diameters_at(pipette, x);
      pieces.push_back({pipette.length / count, pipette.youngs_modulus * second_moment_of_area(d),
                        mass_per_length(d, pipette.density, pipette.fill_density),
                        x > 4e-3 ? d.outer / 2 : 0});
    }
    const std::complex<double> s(1000, 2 * M_PI * 8e3);
    const double error =
        std::abs(TransferFunction(system)(s) / exact_transfer(pieces, pipette.bath.liquid, s) - 1.);
    // Steps in place of a taper: second order.
    if (count == 200) CHECK(std::log2(coarse / error) == Approx(2).margin(0.3));
    CHECK(error < 0.02);
    coarse = error;
  }
}

TEST_CASE("invalid profiles and columns are refused") {
  Pipette pipette;
  pipette.profile = {{0, 10e-6, 8e-6}, {0, 10e-6, 8e-6}};
  CHECK_THROWS_WITH(check(pipette), Catch::Contains("increase"));
  pipette.profile = {{0, 10e-6, 8e-6}, {20e-3, 10e-6, 8e-6}};
  CHECK_THROWS_WITH(check(pipette), Catch::Contains("not exceed the length"));
  pipette.profile = {{0, 10e-6, 12e-6}};
  CHECK_THROWS_WITH(check(pipette), Catch::Contains("less than outer_diameter"));
  pipette.profile = {};
  pipette.columns = {{2e-3, 1e-3, 1000}};
  CHECK_THROWS_WITH(check(pipette), Catch::Contains("end later"));
}

TEST_CASE("trapezoids, half sines and trains have their shapes") {
  const auto trapezoid = trapezoidal_pulse(2, 100e-6, 20e-6);
  CHECK(displacement(trapezoid, 10e-6) == Approx(1));
  CHECK(displacement(trapezoid, 50e-6) == 2);
  CHECK(kinks(trapezoid).size() == 4);
  CHECK(kinks(trapezoidal_pulse(2, 100e-6, 50e-6)).size() == 3);
  CHECK_THROWS_AS(trapezoidal_pulse(2, 100e-6, 60e-6), std::invalid_argument);
  const auto half_sine = half_sine_pulse(3, 60e-6);
  for (double t = 0; t < 60e-6; t += 0.37e-6)
    CHECK(displacement(half_sine, t) == Approx(3 * std::sin(M_PI * t / 60e-6)).margin(3 * 7.6e-5));
  const auto train = pulse_train(triangular_pulse(1, 60e-6), 3, 100e-6);
  CHECK(displacement(train, 230e-6) == Approx(1));
  CHECK(displacement(train, 80e-6) == 0);
  CHECK(kinks(train).size() == 9);
  CHECK(kinks(pulse_train(triangular_pulse(1, 60e-6), 2, 60e-6)).size() == 5);
  CHECK_THROWS_AS(pulse_train(triangular_pulse(1, 60e-6), 2, 50e-6), std::invalid_argument);
  CHECK_THROWS_AS(pulse_train(SineMotion{1, 1}, 2, 50e-6), std::invalid_argument);
  // A train is the sum of its pulses: the beam is linear.
  const BeamSystem system = cantilever(test::pipette_with("water", 10));
  const Sampling sampling{1e-3, 1e-6};
  const TipHistory one = integrate(system, triangular_pulse(1, 60e-6), sampling, Modal{});
  const TipHistory three = integrate(system, train, sampling, Modal{});
  for (std::size_t i = 200; i < three.time.size(); ++i)
    CHECK(three.displacement[i] ==
          Approx(one.displacement[i] + one.displacement[i - 100] + one.displacement[i - 200])
              .margin(1e-9));
}
