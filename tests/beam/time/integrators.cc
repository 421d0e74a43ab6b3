#include <catch2/catch.hpp>
#include <cmath>

#include "beam/system/natural_modes.h"
#include "beam/time/newmark_stepper.h"
#include "tests/beam/cases.h"

using namespace zona::beam;

namespace {

const SupportMotion at_rest = SampledMotion{{0, 1}, {0, 0}};

}  // namespace

TEST_CASE("Newmark conserves the energy of free vibration") {
  const BeamSystem system = cantilever(test::pipette_with("mercury"));
  NewmarkStepper stepper(system, at_rest, 0.6e-6);
  // A plucked tip excites all modes.
  Eigen::VectorXd plucked = 1e-9 * system.observation;
  BandFactor(system.stiffness).solve_in_place(plucked);
  stepper.set_state(0, plucked, 0.01 * system.observation);
  const double energy = stepper.energy();
  stepper.advance(0, 10000 * 0.6e-6);
  // Rounding of 10^4 steps, each amplified by the condition of M + h^2 K / 4.
  CHECK(stepper.energy() == Approx(energy).epsilon(1e-10));
}

TEST_CASE("Newmark is of second order, whether or not kinks fall on its steps") {
  const BeamSystem system = cantilever(test::pipette_with("mercury", 4));
  for (const double duration : {60e-6, 61.7e-6}) {
    const auto pulse = triangular_pulse(1, duration);
    const Sampling sampling{2e-3, 2e-6};
    const TipHistory exact = integrate(system, pulse, sampling, Modal{});
    double coarse = 0;
    for (const int steps : {2, 4, 8}) {
      const TipHistory newmark = integrate(system, pulse, sampling, Newmark{steps});
      const double error = test::greatest_difference(newmark.displacement, exact.displacement);
      // omega h < 0.05 for all modes: terms of fourth order are a thousandth.
      if (coarse > 0) CHECK(std::log2(coarse / error) == Approx(2).margin(0.05));
      coarse = error;
      CHECK(error < 0.01);
    }
  }
}

TEST_CASE("ARKODE's error follows its tolerance, explicit and implicit") {
  const BeamSystem system = cantilever(test::pipette_with("water", 8));
  const auto pulse = triangular_pulse(1, 61.7e-6);
  const Sampling sampling{2e-3, 5e-6};
  const TipHistory exact = integrate(system, pulse, sampling, Modal{});
  for (const RungeKutta method : {RungeKutta::explicit_8, RungeKutta::implicit_5}) {
    double coarse = 0;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const TipHistory arkode =
          integrate(system, pulse, sampling, Arkode{tolerance, tolerance, method});
      const double error = test::greatest_difference(arkode.displacement, exact.displacement);
      // Errors of several hundred to several thousand steps add up, at worst linearly.
      CHECK(error < 1000 * tolerance);
      // A hundredth of the tolerance: at least a thirtieth of the error.
      if (coarse > 0) CHECK(error < coarse / 30);
      coarse = error;
    }
  }
}

TEST_CASE("modal superposition with kinks anywhere is exact at any sampling") {
  const BeamSystem system = cantilever(test::pipette_with("water", 8));
  const SampledMotion trace{{3e-6, 10e-6, 17.3e-6, 40e-6, 55.1e-6}, {0, 1, 0.3, 0.7, 0.2}};
  const TipHistory coarse = integrate(system, trace, {1e-3, 20e-6}, Modal{});
  const TipHistory fine = integrate(system, trace, {1e-3, 1e-6}, Modal{});
  for (std::size_t i = 0; i < coarse.time.size(); ++i) {
    // They differ only by rounding of the phases.
    CHECK(coarse.displacement[i] == Approx(fine.displacement[20 * i]).margin(1e-10));
    CHECK(coarse.support[i] == displacement(SupportMotion(trace), coarse.time[i]));
  }
}

TEST_CASE("velocity and acceleration are the derivatives of displacement, for every integrator") {
  const BeamSystem system = cantilever(test::pipette_with("mercury", 4));
  const auto pulse = triangular_pulse(1, 60e-6);
  for (const Integrator integrator :
       {Integrator(Newmark{4}), Integrator(Modal{}), Integrator(Arkode{1e-8, 1e-10})}) {
    const TipHistory history = integrate(system, pulse, {1e-3, 0.5e-6}, integrator);
    const double scale_v = std::abs(history.velocity[index_of_peak(history.velocity)]);
    const double scale_a = std::abs(history.acceleration[index_of_peak(history.acceleration)]);
    for (std::size_t i = 1; i + 1 < history.time.size(); ++i) {
      const double t = history.time[i];
      if (std::abs(t - 30e-6) < 1e-6 || std::abs(t - 60e-6) < 1e-6) continue;  // kinks
      const double h = history.time[i + 1] - history.time[i - 1];
      // Central differences: (omega h)^2 / 24 of the highest of four elements' modes, 0.0005.
      CHECK((history.displacement[i + 1] - history.displacement[i - 1]) / h ==
            Approx(history.velocity[i]).margin(2e-3 * scale_v));
      CHECK((history.velocity[i + 1] - history.velocity[i - 1]) / h ==
            Approx(history.acceleration[i]).margin(2e-3 * scale_a));
    }
  }
}
