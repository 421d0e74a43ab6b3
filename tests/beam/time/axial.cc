#include <catch2/catch.hpp>
#include <cmath>

#include "beam/frequency/transfer_function.h"
#include "beam/system/natural_modes.h"
#include "tests/beam/cases.h"

using namespace zona::beam;

namespace {

/// Speed of a longitudinal wave in the glass [m/s].
double wave_speed(const Pipette& pipette) {
  return std::sqrt(pipette.youngs_modulus / pipette.density);
}

/// Tip of a uniform rod by d'Alembert's solution: g leaves the support, doubles at the free end and
/// changes its sign at the support, 2 g(t - T) - 2 g(t - 3 T) + ... with T = L/c. A kink may fall
/// on a sample, so only the displacement is compared.
double dalembert(double time, double travel, double peak, double duration) {
  double tip = 0, sign = 2;
  for (double local = time - travel; local > 0; local -= 2 * travel, sign = -sign)
    tip += sign * peak * std::max(0., 1 - std::abs(2 * local / duration - 1));
  return tip;
}

double greatest_error(const TipHistory& tip, double travel, double peak, double duration) {
  double error = 0;
  for (std::size_t i = 0; i < tip.time.size(); ++i)
    error = std::max(
        error, std::abs(tip.displacement[i] - dalembert(tip.time[i], travel, peak, duration)));
  return error;
}

/// The n-th root of tan(k L) = -k b, b = L r1/(r0 - r1), by bisection.
double cone_root(int n, double length, double b) {
  const auto f = [=](double k) { return std::sin(k * length) + k * b * std::cos(k * length); };
  double low = (n - 0.5) * M_PI / length, high = n * M_PI / length;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (f(low) * f(middle) <= 0 ? high : low) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("a uniform rod has the frequencies (2n - 1) c/(4 L), to the sixth order") {
  const double exact = 5 * wave_speed(Pipette{}) / (4 * 10e-3);
  double coarse = 0;
  for (const int elements : {4, 8, 16}) {
    const Eigen::VectorXd frequency =
        natural_modes(axial_rod(test::pipette_with("none", elements))).frequency();
    const double error = frequency(2) / exact - 1;
    CHECK(error > 0);
    if (coarse > 0) CHECK(std::log2(coarse / error) == Approx(6).margin(0.2));
    coarse = error;
  }
  const NaturalModes empty = natural_modes(axial_rod(test::pipette_with("none")));
  CHECK(empty.frequency()(0) == Approx(131.3e3).epsilon(1e-3));
}

TEST_CASE("a conical rod has the frequencies of its exact equation") {
  // With u = w/r, r(x) the radius, (r^2 u')' = -k^2 r^2 u becomes w'' = -k^2 w: w = sin(k x), and
  // u' = 0 at the tip is w' r1 = w r', that is tan(k L) = -k L r1/(r0 - r1).
  Pipette cone = test::pipette_with("none", 40);
  cone.inner_diameter = 0;
  cone.profile = {{0, 10e-6, 0}, {10e-3, 40e-6, 0}};
  const double speed = std::sqrt(cone.youngs_modulus / cone.density);
  const NaturalModes modes = natural_modes(axial_rod(cone));
  for (int n = 1; n <= 4; ++n) {
    const double exact = speed * cone_root(n, cone.length, cone.length * 10 / (40 - 10));
    CHECK(modes.angular_frequency(n - 1) == Approx(exact).epsilon(1e-8));
  }
}

TEST_CASE("the tip of a rod follows d'Alembert's solution for a triangular pulse") {
  constexpr double peak = 17.9e-6, duration = 60e-6;
  const Sampling sampling{200e-6, 0.1e-6};
  const SupportMotion pulse = triangular_pulse(peak, duration);
  for (const double density : {2300., 26441.}) {  // glass, and with the mass of mercury
    Pipette pipette = test::pipette_with("none", 80);
    pipette.density = density;
    const double travel = pipette.length / wave_speed(pipette);
    const BeamSystem rod = axial_rod(pipette);
    // Errors come from the kinks only: the mesh smooths them over an element or two, more so for
    // denser glass, and Newmark over (t dt^2)^(1/3).
    const double by_modes =
        greatest_error(integrate(rod, pulse, sampling, Modal{}), travel, peak, duration);
    CHECK(by_modes < 2e-3 * peak);
    CHECK(greatest_error(integrate_by_transform(rod, pulse, sampling), travel, peak, duration) <
          2e-3 * peak);
    const auto by_newmark = [&](int steps) {
      return greatest_error(integrate(rod, pulse, sampling, Newmark{steps}), travel, peak,
                            duration);
    };
    CHECK(by_newmark(16) < 5e-3 * peak);
    CHECK(by_newmark(16) < 0.7 * by_newmark(8));
    pipette.elements = 160;
    const BeamSystem finer = axial_rod(pipette);
    CHECK(greatest_error(integrate(finer, pulse, sampling, Modal{}), travel, peak, duration) <
          0.6 * by_modes);
  }
}

TEST_CASE("all integrators agree on a damped rod") {
  Pipette pipette = test::pipette_with("none", 10);
  pipette.damping_alpha = 5e3;
  pipette.damping_beta = 1e-7;
  const BeamSystem rod = axial_rod(pipette);
  const SupportMotion pulse = half_sine_pulse(1e-6, 20e-6);
  const Sampling sampling{60e-6, 0.2e-6};
  const auto exact = integrate(rod, pulse, sampling, Modal{}).displacement;
  const Arkode arkode{1e-8, 1e-14, RungeKutta::implicit_5};
  CHECK(test::greatest_difference(exact, integrate(rod, pulse, sampling, arkode).displacement) <
        1e-11);
  CHECK(test::greatest_difference(
            exact, integrate(rod, pulse, sampling, Newmark{20}).displacement) < 1e-10);
  CHECK(test::greatest_difference(
            exact, integrate_by_transform(rod, pulse, sampling).displacement) < 1e-9);
}

TEST_CASE("transform and Newmark agree on a rod of lossy glass") {
  Pipette pipette = test::pipette_with("none", 20);
  pipette.density = 26441;
  pipette.loss_factor = 0.02;
  const BeamSystem rod = axial_rod(pipette);
  const SupportMotion pulse = half_sine_pulse(1e-6, 60e-6);
  const Sampling sampling{300e-6, 0.2e-6};
  // The kinks of the half sine's pieces leave Newmark less than second order: 1.8e-9 with 4 steps.
  const auto newmark = integrate(rod, pulse, sampling, Newmark{8}).displacement;
  CHECK(test::greatest_difference(
            newmark, integrate_by_transform(rod, pulse, sampling).displacement) < 1e-9);
}

TEST_CASE("a rod is held at one end, has an axial rigidity and responds linearly") {
  Section section;
  section.length = 1;
  section.flexural_rigidity = section.mass_per_length = [](double) { return 1; };
  const auto stretched = [&](Supports supports) {
    return assemble(section, {4, supports, 1, Deformation::stretching});
  };
  CHECK_THROWS_AS(stretched(Supports::clamped_free), std::invalid_argument);
  section.axial_rigidity = [](double) { return 1; };
  CHECK_THROWS_AS(stretched(Supports::pinned_pinned), std::invalid_argument);
  CHECK(natural_modes(stretched(Supports::clamped_free)).angular_frequency(0) ==
        Approx(M_PI / 2).epsilon(1e-7));
  CHECK(peak_displacement(scaled(triangular_pulse(2, 1), -0.5)) == 1);
  CHECK(std::get<SineMotion>(scaled(SineMotion{2, 3}, 0.5)).amplitude == 1);
  CHECK_THROWS_AS(scaled(SineMotion{2, 3}, INFINITY), std::invalid_argument);
}
