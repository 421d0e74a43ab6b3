#include <catch2/catch.hpp>

#include "tests/beam/cases.h"

using namespace zona::beam;

namespace {

constexpr int exact_modes = 1000;  // further modes change no ratio by more than 1e-5
const Sampling run_sampling{5e-3, 0.6e-6};

double cubic_element_error(double root, int elements) {
  return std::pow(root / elements, 4) / 1440;  // relative error of omega, leading term
}

}  // namespace

TEST_CASE("forty amplitudes: Newmark converges to modal superposition on one mesh") {
  for (const auto& [fluid, duration] : test::figure_5_28()) {
    CAPTURE(fluid, duration);
    const auto pulse = triangular_pulse(1, duration);
    const BeamSystem system = cantilever(test::pipette_with(fluid));
    const TipHistory modal = integrate(system, pulse, run_sampling, Modal{});
    const TipHistory newmark = integrate(system, pulse, run_sampling, Newmark{32});

    // Average acceleration lengthens the period by (omega h)^2 / 12; the 40 modes of the mesh.
    const ExactCantilever modes(uniform_beam(test::pipette_with(fluid)), 40);
    const double h = run_sampling.step / 32;
    CHECK(test::greatest_difference(newmark.displacement, modal.displacement) <
          test::phase_error_bound(modes, pulse, run_sampling.end, [h](double omega, double) {
            return omega * omega * h * h / 12;
          }));
  }
}

TEST_CASE("forty amplitudes: ARKODE agrees with modal superposition on one mesh") {
  for (const auto& [fluid, duration] : test::figure_5_28()) {
    CAPTURE(fluid, duration);
    const auto pulse = triangular_pulse(1, duration);
    const BeamSystem system = cantilever(test::pipette_with(fluid));
    const TipHistory modal = integrate(system, pulse, run_sampling, Modal{});
    const TipHistory arkode = integrate(system, pulse, run_sampling, Arkode{1e-4, 1e-6});
    // Some 10^4 steps with a local error of about 1e-6 add up at random to 1e-4, at worst to 1e-2.
    CHECK(test::greatest_difference(arkode.displacement, modal.displacement) < 1e-3);
    CHECK(amplitude_ratio(arkode, 1) == Approx(amplitude_ratio(modal, 1)).margin(1e-3));
  }
}

TEST_CASE("forty amplitudes: finite elements converge to the continuum") {
  double worst[3] = {};
  for (const auto& [fluid, duration] : test::figure_5_28()) {
    CAPTURE(fluid, duration);
    const auto pulse = triangular_pulse(1, duration);
    const ExactCantilever exact(uniform_beam(test::pipette_with(fluid)), exact_modes);
    const TipHistory reference = exact.tip_history(pulse, run_sampling);
    int level = 0;
    for (const int elements : {20, 40, 80}) {
      const BeamSystem system = cantilever(test::pipette_with(fluid, elements));
      const TipHistory modal = integrate(system, pulse, run_sampling, Modal{});
      const double difference =
          test::greatest_difference(modal.displacement, reference.displacement);
      CHECK(difference <
            test::phase_error_bound(
                exact, pulse, run_sampling.end,
                [&](double, double root) { return cubic_element_error(root, elements); }));
      const double error = std::abs(amplitude_ratio(modal, 1) - amplitude_ratio(reference, 1));
      worst[level] = std::max(worst[level], error);
      ++level;
    }
  }
  // The error is phase drift of the modes that ring on to the end. Modes are right up to a number
  // that grows as elements^(2/3), amplitudes fall as mode^-3: second order in the element length
  // overall.
  CHECK(worst[1] < worst[0] / 4);
  CHECK(worst[2] < worst[1] / 2);
  CHECK(worst[2] < 0.015);
}

TEST_CASE(
    "forty amplitudes: denser fills ring less for the shortest pulse, as the source concludes") {
  const auto pulse = triangular_pulse(1, 60e-6);
  double previous = 10;
  for (const char* fluid : {"none", "water", "fluorinert", "mercury"}) {
    const ExactCantilever exact(uniform_beam(test::pipette_with(fluid)), exact_modes);
    const double ratio = amplitude_ratio(exact.tip_history(pulse, run_sampling), 1);
    CHECK(ratio < previous);
    previous = ratio;
  }
}

TEST_CASE("the dissertation's own mesh and step are reproducible in milliseconds") {
  const BeamSystem system = cantilever(test::pipette_with("mercury"));
  const TipHistory history =
      integrate(system, triangular_pulse(17.9e-6, 60e-6), run_sampling, Newmark{});
  CHECK(history.time.size() == 8335);
  CHECK(history.time.back() >= 5e-3);
  CHECK(history.displacement.size() == history.acceleration.size());
}
