#include <catch2/catch.hpp>
#include <cmath>

#include "beam/system/natural_modes.h"
#include "beam/system/oscillator.h"
#include "beam/time/newmark_stepper.h"
#include "tests/beam/cases.h"

using namespace zona::beam;

namespace {

const SupportMotion at_rest = SampledMotion{{0, 1}, {0, 0}};

/// Greatest relative tip displacement that kinks can cause.
double ringing(const Pipette& pipette, const SupportMotion& motion) {
  const ExactCantilever exact(uniform_beam(pipette), 200);
  double bound = 0;
  for (const Kink& kink : kinks(motion))
    for (int n = 1; n <= exact.modes(); ++n)
      bound += std::abs(exact.tip_share(n) * kink.velocity_jump) / exact.angular_frequency(n);
  return bound;
}

}  // namespace

TEST_CASE("the tip follows a very slow support") {
  const Pipette pipette = test::pipette_with("mercury");
  const BeamSystem system = cantilever(pipette);
  const auto slow = triangular_pulse(1, 1000);
  CHECK(ringing(pipette, slow) < 1e-4);
  for (const Integrator integrator : {Integrator(Newmark{}), Integrator(Modal{})}) {
    const TipHistory history = integrate(system, slow, {1200, 0.1}, integrator);
    // Newmark at a step of many periods keeps the energy of every mode, hence twice the exact
    // ringing.
    CHECK(test::greatest_difference(history.displacement, history.support) <
          2 * ringing(pipette, slow));
    CHECK(amplitude_ratio(history, 1) == Approx(1).margin(2e-4));
  }
}

TEST_CASE("the tip follows the support of a rigid beam") {
  Pipette pipette = test::pipette_with("none", 4);
  pipette.youngs_modulus *= 1e8;
  const auto pulse = triangular_pulse(1, 600e-6);
  for (const Integrator integrator : {Integrator(Newmark{8}), Integrator(Modal{})}) {
    const TipHistory history = integrate(cantilever(pipette), pulse, {1e-3, 0.6e-6}, integrator);
    CHECK(test::greatest_difference(history.displacement, history.support) <
          2 * ringing(pipette, pulse));
  }
  CHECK(ringing(pipette, pulse) < 0.005);
}

TEST_CASE("the response is linear in the pulse") {
  const BeamSystem system = cantilever(test::pipette_with("water"));
  const TipHistory one = integrate(system, triangular_pulse(1e-6, 90e-6), {}, Newmark{});
  const TipHistory two = integrate(system, triangular_pulse(-2e-6, 90e-6), {}, Newmark{});
  for (std::size_t i = 0; i < one.time.size(); i += 11)
    CHECK(two.displacement[i] == Approx(-2 * one.displacement[i]).margin(1e-15));
}

TEST_CASE("one mode under Rayleigh damping decays as in closed form") {
  Pipette pipette = test::pipette_with("mercury");
  pipette.damping_alpha = 100;
  pipette.damping_beta = 1e-5;
  const BeamSystem system = cantilever(pipette);
  const NaturalModes modes = natural_modes(system);
  for (const int n : {0, 2}) {
    const double omega = modes.angular_frequency(n);
    const double sigma = (pipette.damping_alpha + pipette.damping_beta * omega * omega) / 2;
    const double damped = std::sqrt(omega * omega - sigma * sigma);
    NewmarkStepper stepper(system, at_rest, 1e-6);
    stepper.set_state(0, modes.shape.col(n), Eigen::VectorXd::Zero(system.size()));
    const double start = stepper.observed().displacement;
    for (int i = 0; i < 20; ++i) {
      stepper.advance(i * 1e-4, (i + 1) * 1e-4);
      const double t = (i + 1) * 1e-4;
      const double exact =
          std::exp(-sigma * t) * (std::cos(damped * t) + sigma / damped * std::sin(damped * t));
      // Period error (omega h)^2 / 12 over omega t: 2e-6 for the third mode.
      CHECK(stepper.observed().displacement ==
            Approx(start * exact).margin(1e-5 * std::abs(start)));
    }
  }
}

TEST_CASE("damped pulses: three integrators agree with the damped continuum") {
  Pipette pipette = test::pipette_with("mercury", 40);
  pipette.damping_alpha = 300;
  pipette.damping_beta = 4e-7;  // modes above 5e6 rad/s are overdamped, high ones die within 100 us
  const BeamSystem system = cantilever(pipette);
  const auto pulse = triangular_pulse(1, 61.7e-6);
  const Sampling sampling{2e-3, 0.6e-6};
  const ExactCantilever continuum(uniform_beam(pipette), 400);
  const TipHistory exact =
      continuum.tip_history(pulse, sampling, {pipette.damping_alpha, pipette.damping_beta});
  const TipHistory modal = integrate(system, pulse, sampling, Modal{});
  // Half the undamped bound is reached only by modes that damping has removed by then.
  const double bound =
      test::phase_error_bound(continuum, pulse, sampling.end,
                              [](double, double root) { return std::pow(root / 40, 4) / 1440; });
  CHECK(test::greatest_difference(modal.displacement, exact.displacement) < bound / 2);
  const TipHistory newmark = integrate(system, pulse, sampling, Newmark{32});
  CHECK(test::greatest_difference(newmark.displacement, modal.displacement) < 1e-3);
  const TipHistory arkode =
      integrate(system, pulse, sampling, Arkode{1e-6, 1e-7, RungeKutta::implicit_5});
  CHECK(test::greatest_difference(arkode.displacement, modal.displacement) < 1e-4);
}

TEST_CASE("an oscillator's impulse response is right from undamped to overdamped") {
  // Taylor series of x'' + 2 sigma x' + omega^2 x = 0 with x = 0, x' = 1, to rounding.
  for (const double sigma : {0., 0.3, 0.999999999, 1., 1.000000001, 3., 10.}) {
    const double omega = 1, time = 0.7;
    double a = 0, b = 1, term = 1, x = 0, v = 1;
    for (int k = 1; k < 200; ++k) {
      // derivatives: y_(k+1) = -omega^2 y_(k-1) - 2 sigma y_k
      const double next = -omega * omega * a - 2 * sigma * b;
      term *= time / k;
      x += b * term;
      v += next * term;
      a = b, b = next;
    }
    const ImpulseResponse response = impulse_response(omega, sigma, time);
    // The series cancels e^(2 sigma t) of its own size.
    const double rounding = 1e-15 * std::exp(2 * sigma * time) + 1e-8 * (sigma != 0 && sigma < 1.1);
    CHECK(response.displacement == Approx(x).margin(10 * rounding));
    CHECK(response.velocity == Approx(v).margin(100 * rounding));
  }
  CHECK(impulse_response(1, 0, -1).displacement == 0);
}
