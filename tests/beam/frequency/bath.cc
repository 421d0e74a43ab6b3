#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "beam/exact/transfer.h"
#include "beam/frequency/transfer_function.h"
#include "beam/pipette/hydrodynamics.h"
#include "beam/system/natural_modes.h"
#include "beam/system/relaxation.h"
#include "beam/system/transient_beam.h"
#include "beam/time/modal_stepper.h"
#include "beam/time/newmark_stepper.h"
#include "tests/beam/cases.h"

using namespace zona::beam;
using Complex = std::complex<double>;

namespace {

/// Gamma of a circular cylinder for motion as exp(-i omega t) (Sader, J. Appl. Phys. 84, 64, 1998,
/// eq. 20), with lambda^2 = -i Re.
Complex hydrodynamic_function(double reynolds_number) {
  const Complex lambda = std::sqrt(Complex(0, -reynolds_number));
  return 1. + 4. * outer_ratio(lambda) / (lambda * lambda);
}

/// The pipette of Table 5.5, immersed over a length from its tip.
Pipette immersed(const std::string& fluid, double length, int elements = 80) {
  Pipette pipette = test::pipette_with(fluid, elements);
  pipette.bath.model = BathModel::frequency;
  pipette.bath.immersed_length = length;
  return pipette;
}

/// Pieces of the pipette for the exact solution.
std::vector<UniformPiece> pieces_of(const Pipette& pipette) {
  Pipette dry = pipette;
  dry.bath = {};
  const UniformBeam beam = uniform_beam(dry);
  const double above = immersed_from(pipette);
  const double radius = pipette.outer_diameter / 2;
  std::vector<UniformPiece> pieces;
  if (above > 0) pieces.push_back({above, beam.flexural_rigidity, beam.mass_per_length, 0});
  if (above < beam.length)
    pieces.push_back({beam.length - above, beam.flexural_rigidity, beam.mass_per_length, radius});
  return pieces;
}

/// Displacement of the tip by inversion of the exact transfer function.
std::vector<double> exact_tip(const Pipette& pipette, const SupportMotion& motion,
                              const Sampling& sampling) {
  const std::vector<Complex> points = transform_points(sampling);
  std::vector<Complex> values = laplace_transform(motion, points);
  for (std::size_t k = 0; k < points.size(); ++k)
    values[k] *= exact_transfer(pieces_of(pipette), pipette.bath.liquid, points[k]);
  return invert_transform(sampling, values);
}

double greatest(const std::vector<double>& values) {
  return std::abs(values[index_of_peak(values)]);
}

}  // namespace

TEST_CASE("the hydrodynamic function of a cylinder has Sader's values") {
  // mpmath, from 1 + 4i K1(-i sqrt(i Re)) / (sqrt(i Re) K0(-i sqrt(i Re))) with 30 digits.
  CHECK(std::abs(hydrodynamic_function(1) - Complex(3.96801484713663, 4.56657056632795)) < 1e-9);
  CHECK(std::abs(hydrodynamic_function(10) - Complex(1.90204270865963, 1.08405007524811)) < 1e-9);
  // On the real axis of lambda the functions are those of the standard library.
  for (const double x : {1e-3, 0.1, 1., 30.})
    CHECK(outer_ratio(x).real() ==
          Approx(x * std::cyl_bessel_k(1, x) / std::cyl_bessel_k(0, x)).epsilon(1e-12));
  // Stokes' layer is thin: half of its added mass, lambda + 1/2 - 1/(8 lambda).
  const Complex thin = std::polar(200., -M_PI / 4);
  CHECK(std::abs(outer_ratio(thin) - (thin + 0.5 - 1. / (8. * thin))) < 1e-5);
}

TEST_CASE("a few radii suffice to interpolate the load on a taper") {
  Pipette pipette = immersed("none", 10e-3, 20);
  pipette.profile = {{0, 10e-6, 8e-6}, {10e-3, 1e-3, 0.8e-3}};
  CHECK(test::interpolation_error(cantilever(pipette).liquids.viscous) < 1e-5);
}

TEST_CASE("Maxwell elements represent the load of a liquid, and a loss factor") {
  const double lowest = 2 * M_PI * 10, highest = 2 * M_PI * 1e6;
  const RateLadder ladder = RateLadder::over(lowest, highest);
  const Liquid water;
  for (const double radius : {0.5e-6, 5e-6, 50e-6, 500e-6}) {
    const Relaxation viscous = viscous_relaxation(Flow::across, ladder, water, radius);
    CHECK(viscous.weight.minCoeff() > 0);
    for (double omega = lowest; omega < highest; omega *= 1.7) {
      const Complex s(0, omega);
      const Complex exact = viscous_load(Flow::across, water, radius, s);
      // Trapezoidal rule: 2 exp(-pi^2) = 1e-4; at the ends also the omitted elements.
      CHECK(std::abs(evaluate(ladder, viscous, s) / exact - 1.) < 4e-4);
    }
  }
  for (const double loss : {0.001, 0.1, 0.5}) {
    const Relaxation modulus = loss_relaxation(ladder, loss, 2 * M_PI * 1e4);
    for (double omega = lowest; omega < highest; omega *= 1.7) {
      const Complex exact = loss_modulus({0, omega}, loss, 2 * M_PI * 1e4);
      CHECK(exact.imag() / exact.real() == Approx(loss).epsilon(1e-12));
      // Omitted below the ladder: 2/pi loss times p/omega, a thousandth at the lowest frequency.
      CHECK(std::abs(evaluate(ladder, modulus, {0, omega}) / exact - 1.) < 7e-4 * loss);
    }
  }
}

TEST_CASE("the transfer function agrees with the exact one, in air and immersed") {
  for (const std::string fluid : {"none", "mercury"})
    for (const double length : {0., 0.5e-3, 2e-3, 10e-3}) {
      const Pipette pipette = immersed(fluid, length, 160);
      const BeamSystem system = cantilever(pipette);
      const TransferFunction transfer(system);
      // The modes of Table 5.6 end at 2.4 and 8.4 kHz; 30 kHz is the spectrum of a 60 us pulse.
      for (const double frequency : {10., 100., 1000., 8400., 30e3}) {
        const Complex s(300, 2 * M_PI * frequency);
        const Complex exact = exact_transfer(pieces_of(pipette), pipette.bath.liquid, s);
        INFO(fluid << ", " << length << " m, " << frequency << " Hz");
        // (alpha h)^4/5760 < 4e-6 is the error of alpha, times alpha L < 62 that of the phase, and
        // next to a resonance up to ten times that of the response.
        CHECK(std::abs(transfer(s) - exact) < 2.5e-3 * std::abs(exact));
      }
    }
}

TEST_CASE("a cylinder in vacuum has the transfer function of its modes") {
  const Pipette pipette = test::pipette_with("water", 40);
  const Complex s(0, 2 * M_PI * 400);
  const UniformBeam beam = uniform_beam(pipette);
  const double z =
      beam.length * std::pow(std::norm(s) * beam.mass_per_length / beam.flexural_rigidity, 0.25);
  const double closed = (std::cos(z) + std::cosh(z)) / (1 + std::cos(z) * std::cosh(z));
  CHECK(exact_transfer(pieces_of(pipette), {}, s).real() == Approx(closed).epsilon(1e-10));
  const BeamSystem system = cantilever(pipette);
  CHECK(TransferFunction(system)(s).real() == Approx(closed).epsilon(1e-4));
}

TEST_CASE("the inverse transform gives the motion of modal superposition in vacuum") {
  const BeamSystem system = cantilever(test::pipette_with("mercury", 40));
  const auto pulse = triangular_pulse(1, 61.7e-6);
  const Sampling sampling{5e-3, 0.6e-6};
  const TipHistory modal = integrate(system, pulse, sampling, Modal{});
  const TipHistory transform = integrate(system, pulse, sampling, Transform{});
  // Later times alias with exp(-16); modes above half the sampling frequency are missing.
  CHECK(test::greatest_difference(modal.displacement, transform.displacement) < 2e-5);
}

TEST_CASE("the inverse transform is as accurate at the last samples as at the first") {
  // Stiff and hardly damped, driven by kinks between the samples, which resolve only a small part.
  Pipette pipette = test::pipette_with("water", 80);
  pipette.length = 2.52e-3;
  pipette.profile = {{0, 10e-6, 8e-6}, {pipette.length, 18.32e-6, 14.656e-6}};
  pipette.bath.model = BathModel::frequency;
  pipette.bath.immersed_length = 1e-3;
  const BeamSystem system = cantilever(pipette);
  const auto pulse = triangular_pulse(1, 29.26e-6);
  const TipHistory coarse = integrate(system, pulse, {4e-3, 1e-6}, Transform{});
  const TipHistory fine = integrate(system, pulse, {4e-3, 0.125e-6}, Transform{});
  double difference = 0, speed_difference = 0, speed = 0;
  for (std::size_t i = 200; i < coarse.time.size(); ++i) {
    difference = std::max(difference, std::abs(coarse.displacement[i] - fine.displacement[8 * i]));
    speed_difference =
        std::max(speed_difference, std::abs(coarse.velocity[i] - fine.velocity[8 * i]));
    speed = std::max(speed, std::abs(fine.velocity[8 * i]));
  }
  CHECK(difference < 1e-3 * greatest(fine.displacement));
  CHECK(speed_difference < 0.01 * speed);
}

TEST_CASE("immersed, the inverse transform gives the exact motion of the tip") {
  const auto pulse = triangular_pulse(1, 60e-6);
  const Sampling sampling{5e-3, 0.6e-6};
  for (const std::string fluid : {"none", "mercury"})
    for (const double length : {1e-3, 10e-3}) {
      const Pipette pipette = immersed(fluid, length, 160);
      const std::vector<double> exact = exact_tip(pipette, pulse, sampling);
      const TipHistory tip = integrate(cantilever(pipette), pulse, sampling, Transform{});
      INFO(fluid << ", " << length << " m");
      // The elements' dispersion: falls by 16 when they are halved.
      CHECK(test::greatest_difference(tip.displacement, exact) < 0.01 * greatest(exact));
      CHECK(amplitude_ratio(tip, 1) == Approx(greatest(exact)).epsilon(0.002));
    }
}

TEST_CASE("a fully immersed pipette rings more with a dense fill") {
  // Expected for 10 mm in water: 0.007 empty, 0.009 water, 0.011 Fluorinert, 0.073 mercury.
  const std::vector<std::pair<std::string, double>> known{
      {"none", 0.007}, {"water", 0.009}, {"fluorinert", 0.011}, {"mercury", 0.073}};
  for (const auto& [fluid, ratio] : known) {
    const BeamSystem system = cantilever(immersed(fluid, 10e-3, 160));
    const TipHistory tip =
        integrate(system, triangular_pulse(1, 60e-6), {5e-3, 0.6e-6}, Transform{});
    CHECK(amplitude_ratio(tip, 1) == Approx(ratio).margin(0.00051));
  }
}

TEST_CASE("immersed, the transient integrators agree with the inverse transform") {
  const auto pulse = triangular_pulse(1, 60e-6);
  const Sampling sampling{1e-3, 0.6e-6};
  for (const double length : {1e-3, 10e-3}) {
    Pipette pipette = immersed("water", length, 20);
    pipette.loss_factor = 0.02;
    const BeamSystem system = cantilever(pipette);
    const TipHistory transform = integrate(system, pulse, sampling, Transform{});
    const double peak = greatest(transform.displacement);
    const auto error = [&](const Integrator& integrator) {
      const TipHistory tip = integrate(system, pulse, sampling, integrator);
      return test::greatest_difference(tip.displacement, transform.displacement) / peak;
    };
    INFO(length << " m");
    // The cut at half the sampling frequency causes some 1e-3 where the tip first moves.
    CHECK(error(Newmark{16}) < 2e-3);
    CHECK(error(Newmark{4}) < 2e-2);
    CHECK(error(Arkode{1e-6, 1e-6, RungeKutta::implicit_5}) < 2e-3);
  }
}

TEST_CASE("the transient beam has the exact spectrum up to the sixth mode") {
  const auto pulse = triangular_pulse(1, 60e-6);
  const Sampling sampling{5e-3, 0.6e-6};
  for (const std::string fluid : {"none", "mercury"}) {
    const Pipette pipette = immersed(fluid, 10e-3);
    const TipHistory tip = integrate(cantilever(pipette), pulse, sampling, Newmark{});
    // Table 5.6 of each fill: 27.7 to 2355 Hz with mercury, 99 to 8420 Hz without.
    const double first = fluid == "none" ? 99 : 27.7;
    for (const double ratio : {1., 6.267, 17.55, 34.39, 56.84, 84.91}) {
      const Complex s(3000, 2 * M_PI * first * ratio);  // exp(-15) of it is left after 5 ms
      Complex spectrum = 0;
      for (std::size_t i = 0; i < tip.time.size(); ++i)
        spectrum += sampling.step * tip.displacement[i] * std::exp(-s * tip.time[i]);
      const Complex exact = exact_transfer(pieces_of(pipette), pipette.bath.liquid, s) *
                            laplace_transform(pulse, {s}).front();
      INFO(fluid << ", mode at " << first * ratio << " Hz");
      CHECK(std::abs(spectrum / exact - 1.) < 0.01);
    }
  }
}

TEST_CASE("beams in frequency and in time have the exact response up to the sixth mode") {
  for (const std::string fluid : {"none", "mercury"}) {
    const Pipette pipette = immersed(fluid, 10e-3);
    const BeamSystem system = cantilever(pipette);
    const TransferFunction transfer(system);
    const TransientBeam beam = transient_beam(system, {1e2, 1e6});
    const double first = fluid == "none" ? 99 : 27.7;
    for (double frequency = first; frequency < 85 * first; frequency *= 1.3) {
      const Complex s(0, 2 * M_PI * frequency);
      const Complex exact = exact_transfer(pieces_of(pipette), pipette.bath.liquid, s);
      // The transient beam's equations in the Laplace domain, q / g.
      Eigen::MatrixXcd matrix = s * s * beam.mass.dense() + s * beam.damping.dense();
      matrix += beam.stiffness.dense();
      Eigen::VectorXcd load = -(s * s * beam.support_mass + s * beam.support_damping);
      for (std::size_t k = 0; k < beam.basis.size(); ++k) {
        const Complex memory = (beam.weight.col(k).array() * s / (s + beam.rate)).sum();
        matrix += memory * beam.basis[k].dense();
        load -= memory * beam.support[k];
      }
      const Eigen::VectorXcd relative = matrix.partialPivLu().solve(load);
      const Complex transient =
          1. + system.observation.cast<Complex>().cwiseProduct(relative).sum();
      INFO(fluid << ", " << frequency << " Hz");
      CHECK(std::abs(transfer(s) / exact - 1.) < 0.01);
      CHECK(std::abs(transient / exact - 1.) < 0.01);
    }
  }
}

TEST_CASE("Newmark and the transform agree for a bath of constant mass and drag") {
  Pipette pipette = immersed("water", 3e-3, 20);
  pipette.bath.model = BathModel::constant;
  pipette.bath.frequency = 3e3;
  const BeamSystem system = cantilever(pipette);
  const auto pulse = triangular_pulse(1, 60e-6);
  const TipHistory transform = integrate(system, pulse, {2e-3, 0.6e-6}, Transform{});
  const TipHistory newmark = integrate(system, pulse, {2e-3, 0.6e-6}, Newmark{16});
  CHECK(test::greatest_difference(transform.displacement, newmark.displacement) <
        3e-3 * greatest(transform.displacement));
}

TEST_CASE("modes in a bath agree with the exact transfer function") {
  // A thick, slow-moving rod: its modes are sharp, so that a mode is a peak of the response.
  Pipette pipette = immersed("none", 10e-3);
  pipette.outer_diameter = 200e-6;
  pipette.inner_diameter = 160e-6;
  pipette.bath.model = BathModel::per_mode;
  const BeamSystem system = cantilever(pipette);
  const ModalOscillators modes = oscillators(system, natural_modes(system), 3);
  for (int n = 0; n < 3; ++n) {
    const double omega = modes.angular_frequency(n);
    const double width = modes.decay_rate(n);
    const auto response = [&](double at) {
      return std::abs(exact_transfer(pieces_of(pipette), pipette.bath.liquid, {0, at}));
    };
    double peak = omega;
    for (double at = omega - width; at < omega + width; at += width / 200)
      if (response(at) > response(peak)) peak = at;
    INFO("mode " << n + 1 << ", damping ratio " << width / omega);
    CHECK(std::abs(peak - omega) < 0.1 * width);
    // Half the power at omega +- width, to first order in the damping ratio.
    CHECK(response(peak + width) / response(peak) == Approx(std::sqrt(0.5)).epsilon(width / omega));
  }
  const auto pulse = triangular_pulse(1, 60e-6);
  const TipHistory modal = integrate(system, pulse, {2e-3, 0.6e-6}, Modal{});
  pipette.bath.model = BathModel::frequency;
  const TipHistory exact = integrate(cantilever(pipette), pulse, {2e-3, 0.6e-6}, Transform{});
  // Taking the load at each mode's frequency causes an error of the order of the damping ratio, 8
  // %.
  CHECK(test::greatest_difference(modal.displacement, exact.displacement) <
        0.04 * greatest(exact.displacement));
}

TEST_CASE("a loss factor damps every mode by half of itself") {
  Pipette pipette = test::pipette_with("water", 20);
  pipette.loss_factor = 0.03;
  pipette.loss_frequency = 1e3;
  const BeamSystem system = cantilever(pipette);
  const TransferFunction transfer(system);
  const NaturalModes modes = natural_modes(system);
  for (int n : {0, 3}) {
    // (s/w0)^a / cos(a pi/2) at the mode's own frequency: the storage modulus has grown as w^a.
    const double a = 2 / M_PI * std::atan(pipette.loss_factor);
    double omega = modes.angular_frequency(n);
    omega *= std::pow(omega / (2 * M_PI * pipette.loss_frequency), a / (2 - a));
    const double width = omega * pipette.loss_factor / 2;
    const double ratio = std::abs(transfer({0, omega + width})) / std::abs(transfer({0, omega}));
    CHECK(ratio == Approx(std::sqrt(0.5)).epsilon(0.03));
  }
  CHECK(oscillators(system, modes, 2).decay_rate(1) == Approx(0.015 * modes.angular_frequency(1)));
}

TEST_CASE("a quadratic drag dissipates in proportion to the amplitude") {
  // The drag vanishes at small amplitudes and lowers the response per amplitude at large ones.
  Pipette pipette = immersed("mercury", 10e-3, 20);
  pipette.bath.drag_coefficient = 2;
  const BeamSystem system = cantilever(pipette);
  pipette.bath.drag_coefficient = 0;
  const BeamSystem without = cantilever(pipette);
  const Sampling sampling{0.5e-3, 0.6e-6};
  const auto ratio = [&](const BeamSystem& beam, double peak, const Integrator& integrator) {
    return amplitude_ratio(integrate(beam, triangular_pulse(peak, 60e-6), sampling, integrator),
                           peak);
  };
  const double linear = ratio(without, 1e-9, Newmark{4});
  CHECK(ratio(system, 1e-9, Newmark{4}) == Approx(linear).epsilon(1e-3));
  const double small = linear - ratio(system, 1e-6, Newmark{4});
  const double twice = linear - ratio(system, 2e-6, Newmark{4});
  CHECK(small > 0);
  CHECK(twice / small == Approx(2).epsilon(0.1));
  const double strong = ratio(system, 17.9e-6, Newmark{8});
  CHECK(strong < linear);
  CHECK(ratio(system, 17.9e-6, Arkode{1e-5, 1e-11, RungeKutta::implicit_5}) ==
        Approx(strong).epsilon(5e-3));
}

TEST_CASE(
    "drawn through a liquid at constant speed, a pipette bends as a cantilever under the drag") {
  // q = (c + rho C_D a V) V per length on the immersed part, from x = a to the tip at x = L:
  // q (3 L^4 - 4 a^3 L + a^4) / (24 E I), Roark's table for a cantilever under a partial load.
  Pipette pipette = immersed("water", 0.6e-3, 20);
  pipette.length = 1e-3;
  pipette.bath.model = BathModel::constant;
  pipette.bath.frequency = 3e3;
  pipette.bath.drag_coefficient = 1.3;
  const double speed = 0.5, radius = 0.5 * pipette.outer_diameter;
  const Liquid& liquid = pipette.bath.liquid;
  const double linear =
      viscous_load(Flow::across, liquid, radius, {0, 2 * M_PI * pipette.bath.frequency}).real();
  const double load = (linear + liquid.density * 1.3 * radius * speed) * speed;
  const double length = pipette.length, from = length - pipette.bath.immersed_length;
  const double bent =
      load * (3 * std::pow(length, 4) - 4 * std::pow(from, 3) * length + std::pow(from, 4)) /
      (24 * pipette.youngs_modulus * second_moment_of_area(pipette));
  const double end = 1e-3;  // the lowest mode dies out within a tenth of it
  const SampledMotion drawn{{0, end}, {0, speed * end}};
  const TipHistory tip = integrate(cantilever(pipette), drawn, {end, 0.5e-6}, Newmark{16});
  const std::size_t late = tip.time.size() - 10;
  CHECK(tip.support[late] - tip.displacement[late] == Approx(bent).epsilon(2e-5));
}

TEST_CASE("invalid baths are refused") {
  Pipette pipette = immersed("water", 1e-3, 10);
  const auto pulse = triangular_pulse(1, 60e-6);
  const Sampling sampling{1e-4, 1e-6};
  CHECK_THROWS_AS(integrate(cantilever(pipette), pulse, sampling, Modal{}), std::invalid_argument);
  pipette.bath.model = BathModel::per_mode;
  CHECK_THROWS_AS(integrate(cantilever(pipette), pulse, sampling, Newmark{}),
                  std::invalid_argument);
  pipette.bath.model = BathModel::frequency;
  pipette.bath.drag_coefficient = 1;
  CHECK_THROWS_AS(integrate(cantilever(pipette), pulse, sampling, Transform{}),
                  std::invalid_argument);
  pipette.bath.liquid.viscosity = 0;
  CHECK_THROWS_AS(cantilever(pipette), std::invalid_argument);
}
