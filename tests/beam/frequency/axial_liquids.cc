#include <catch2/catch.hpp>
#include <cmath>

#include "beam/exact/transfer.h"
#include "beam/frequency/transfer_function.h"
#include "beam/system/relaxation.h"
#include "beam/system/transient_beam.h"
#include "tests/beam/cases.h"

using namespace zona::beam;
using Complex = std::complex<double>;

namespace {

/// A pipette without profile and columns for the exact solution, from the support to the tip.
std::vector<UniformRodPiece> pieces_of(const Pipette& pipette) {
  const double area = glass_area(diameters_at(pipette, 0));
  UniformRodPiece piece;
  piece.axial_rigidity = pipette.youngs_modulus * area;
  piece.mass_per_length = pipette.density * area;
  piece.inner_radius = pipette.inner_diameter / 2;
  piece.fill = {pipette.fill_density, pipette.fill_viscosity};
  const double above = immersed_from(pipette);
  std::vector<UniformRodPiece> pieces;
  piece.length = above;
  if (above > 0) pieces.push_back(piece);
  piece.length = pipette.length - above;
  piece.outer_radius = pipette.outer_diameter / 2;
  if (piece.length > 0) pieces.push_back(piece);
  return pieces;
}

Pipette dipped(Pipette pipette, double length) {
  pipette.bath.model = BathModel::frequency;
  pipette.bath.immersed_length = length;
  return pipette;
}

std::vector<double> exact_tip(const Pipette& pipette, const SupportMotion& motion,
                              const Sampling& sampling) {
  const std::vector<Complex> points = transform_points(sampling);
  std::vector<Complex> values = laplace_transform(motion, points);
  for (std::size_t k = 0; k < points.size(); ++k)
    values[k] *= exact_rod_transfer(pieces_of(pipette), pipette.bath.liquid, points[k]);
  return invert_transform(sampling, values);
}

double greatest_between(const TipHistory& tip, double from, double to) {
  double greatest = 0;
  for (std::size_t i = 0; i < tip.time.size(); ++i)
    if (tip.time[i] > from && tip.time[i] < to)
      greatest = std::max(greatest, std::abs(tip.displacement[i]));
  return greatest;
}

}  // namespace

TEST_CASE("the load of a bore agrees with modified Bessel functions and their poles") {
  for (const double x : {1e-3, 0.1, 1., 10., 59.9, 60.1, 300.})
    CHECK(bore_ratio(x).real() ==
          Approx(x * std::cyl_bessel_i(1, x) / std::cyl_bessel_i(0, x)).epsilon(1e-11));
  // x I1/I0 = 2 sum of x^2/(x^2 + j_n^2) with the zeros j_n of J0. For large n j_n = (n - 1/4) pi,
  // and the remainder after N terms is 2 x^2 / (pi^2 N).
  for (const Complex x :
       {std::polar(0.3, M_PI / 4), std::polar(4., 0.6), std::polar(50., M_PI / 4)}) {
    Complex sum = 0;
    const int count = 100000;
    for (int n = count; n >= 1; --n) {
      const double beta = (n - 0.25) * M_PI;
      double zero = beta + 1 / (8 * beta) - 124 / (3 * std::pow(8 * beta, 3));
      for (int step = 0; step < 3 && n < 20; ++step)
        zero += std::cyl_bessel_j(0, zero) / std::cyl_bessel_j(1, zero);
      sum += 2. * x * x / (x * x + zero * zero);
    }
    sum += 2. * x * x / (M_PI * M_PI * (count + 0.25));
    CHECK(std::abs(bore_ratio(x) / sum - 1.) < 1e-7);
  }
}

TEST_CASE("a bore's fluid follows slow motions as a whole, fast ones in a layer") {
  const Liquid mercury{13600, 1.526e-3};
  const double radius = 4e-6, mass = mercury.density * M_PI * radius * radius;
  const Complex slow(0, 10), fast(0, 1e9);
  CHECK(std::abs(viscous_load(Flow::within, mercury, radius, slow) / (slow * mass) - 1.) < 2e-4);
  // Layer of thickness sqrt(nu/s) around the bore.
  const Complex layer = std::sqrt(mercury.viscosity / mercury.density / fast);
  CHECK(std::abs(viscous_load(Flow::within, mercury, radius, fast) /
                     (fast * mercury.density * 2. * M_PI * radius * layer) -
                 1.) < 3e-3);
  // A thin layer has the same load on both sides of a wall; along a cylinder the load is half of
  // that across.
  const Complex within = viscous_load(Flow::within, mercury, radius, fast),
                along = viscous_load(Flow::along, mercury, radius, fast);
  CHECK(std::abs(along / within - 1.) < 6e-3);
  CHECK(viscous_load(Flow::across, mercury, radius, fast) == 2. * along);
}

TEST_CASE("Maxwell elements represent the load of a bore, and that along a cylinder") {
  const double lowest = 2 * M_PI * 10, highest = 2 * M_PI * 1e6;
  const RateLadder ladder = RateLadder::over(lowest, highest, 0.5);
  for (const Liquid& liquid : {Liquid{}, Liquid{13600, 1.526e-3}, Liquid{1018, 0.5}})
    for (const double radius : {0.4e-6, 4e-6, 40e-6, 400e-6})
      for (const Flow flow : {Flow::within, Flow::along}) {
        const Relaxation load = viscous_relaxation(flow, ladder, liquid, radius);
        double error = 0;
        for (double omega = lowest; omega < highest; omega *= 1.3) {
          const Complex exact = viscous_load(flow, liquid, radius, {0, omega});
          error = std::max(error, std::abs(evaluate(ladder, load, {0, omega}) / exact - 1.));
        }
        INFO("radius " << radius << ", viscosity " << liquid.viscosity);
        // Cubics in ln p between rates that stand half of a unit apart: 9/16 h^4/24 = 1.5e-3 of the
        // fourth derivative of 1/(1 + s/p), which is of order one.
        CHECK(error < 3e-3);
      }
}

TEST_CASE("a few radii suffice to interpolate the load within a taper") {
  Pipette pipette = test::pipette_with("mercury", 20);
  pipette.profile = {{0, 10e-6, 8e-6}, {10e-3, 100e-6, 80e-6}};
  CHECK(test::interpolation_error(axial_rod(pipette).liquids.viscous) < 2e-4);
}

TEST_CASE("a filled rod has the exact transfer function, in air and dipped") {
  for (const char* fluid : {"none", "water", "mercury", "light_oil"})
    for (const double dip : {0., 1e-3, 10e-3}) {
      const Pipette pipette = dipped(test::pipette_with(fluid, 40), dip);
      const BeamSystem system = axial_rod(pipette);
      const TransferFunction transfer(system);
      for (const double frequency : {10., 1e3, 17e3, 100e3, 400e3}) {
        const Complex s(300, 2 * M_PI * frequency);
        const Complex exact = exact_rod_transfer(pieces_of(pipette), pipette.bath.liquid, s);
        INFO(fluid << ", " << dip << " m, " << frequency << " Hz");
        // (k h)^6 / 4e5 of the frequency is 1e-9 at 400 kHz.
        CHECK(std::abs(transfer(s) / exact - 1.) < 1e-6);
      }
    }
}

TEST_CASE("columns of fluids in a rod have the transfer function of their pieces") {
  Pipette pipette = test::pipette_with("none", 40);
  pipette.columns = {{0, 1e-3, 1000, 8.9e-4}, {3e-3, 10e-3, 13600, 1.526e-3}};
  const BeamSystem system = axial_rod(pipette);
  const UniformRodPiece empty = pieces_of(pipette).front();
  UniformRodPiece mercury = empty, air = empty, water = empty;
  mercury.length = 7e-3;
  mercury.fill = {13600, 1.526e-3};
  air.length = 2e-3;
  water.length = 1e-3;
  water.fill = {1000, 8.9e-4};
  for (const double frequency : {100., 17e3, 150e3}) {
    const Complex s(100, 2 * M_PI * frequency);
    CHECK(std::abs(TransferFunction(system)(s) / exact_rod_transfer({mercury, air, water}, {}, s) -
                   1.) < 1e-6);
  }
}

TEST_CASE("the inertia of glass and fluid stretches a slow rod") {
  // u = g + g'' (rho_bar) (x^2/2 - L x)/EA: at the tip T = 1 - s^2 rho_bar L^2/(2 EA).
  const Pipette pipette = test::pipette_with("mercury", 10);
  const BeamSystem system = axial_rod(pipette);
  const Diameters diameters = diameters_at(pipette, 0);
  const double rigidity = pipette.youngs_modulus * glass_area(diameters);
  const double s = 30;  // 0.0005 of the fluid lags
  const double expected = mass_per_length(pipette) * 1e-4 / (2 * rigidity);
  CHECK((1 - TransferFunction(system)(s).real()) / (s * s) == Approx(expected).epsilon(2e-3));
}

TEST_CASE("a filled rod comes to rest, by every integrator") {
  constexpr double peak = 17.9e-6;
  const SupportMotion pulse = triangular_pulse(peak, 60e-6);
  const Sampling sampling{500e-6, 0.6e-6};
  for (const std::string fluid : {"water", "mercury"}) {
    const Pipette pipette = test::pipette_with(fluid, 40);
    const BeamSystem system = axial_rod(pipette);
    const TipHistory tip = integrate(system, pulse, sampling, Transform{});
    INFO(fluid);
    CHECK(test::greatest_difference(tip.displacement, exact_tip(pipette, pulse, sampling)) <
          1e-3 * peak);
    const auto error = [&](const Integrator& integrator) {
      return test::greatest_difference(integrate(system, pulse, sampling, integrator).displacement,
                                       tip.displacement) /
             peak;
    };
    // The transform has no frequencies above half of the samples', which rounds the kinks.
    CHECK(error(Newmark{16}) < 6e-3);
    CHECK(error(Arkode{1e-6, 1e-12, RungeKutta::implicit_5}) < 6e-3);
    CHECK(error(Modal{}) < 0.05);
  }
  // Numbers of docs/theory/beam.md, computed there from 1/cosh(k L) and, in brackets, with the
  // pressure of a compressible fluid: 1.0715 (1.0709), and 0.026 um (0.029) from 100 us on. A fluid
  // that follows completely would give 4.9 um.
  const TipHistory tip =
      integrate(axial_rod(test::pipette_with("mercury", 40)), pulse, {500e-6, 0.2e-6}, Transform{});
  CHECK(amplitude_ratio(tip, peak) == Approx(1.0715).margin(0.0005));
  CHECK(greatest_between(tip, 100e-6, 400e-6) == Approx(0.026e-6).margin(0.002e-6));
}

TEST_CASE("a bath damps an empty rod that would ring") {
  const SupportMotion pulse = triangular_pulse(1, 60e-6);
  const Sampling sampling{500e-6, 0.6e-6};
  const Pipette empty = test::pipette_with("none", 40);
  const Pipette wet = dipped(empty, 1e-3);
  const TipHistory in_air = integrate(axial_rod(empty), pulse, sampling, Transform{});
  const TipHistory in_water = integrate(axial_rod(wet), pulse, sampling, Transform{});
  CHECK(test::greatest_difference(in_water.displacement, exact_tip(wet, pulse, sampling)) < 1e-3);
  CHECK(greatest_between(in_air, 360e-6, 500e-6) > 0.015);
  CHECK(greatest_between(in_water, 360e-6, 500e-6) < 1e-4);
  // Only motion across the pipette has a quadratic drag.
  Pipette dragged = wet;
  dragged.bath.drag_coefficient = 1;
  CHECK(axial_rod(dragged).liquids.drag.empty());
  dragged.bath.model = BathModel::per_mode;
  CHECK_NOTHROW(integrate(axial_rod(dragged), pulse, sampling, Modal{}));
  CHECK_THROWS_AS(integrate(axial_rod(dragged), pulse, sampling, Transform{}),
                  std::invalid_argument);
}

TEST_CASE("a fluid without viscosity is refused") {
  Pipette pipette = test::pipette_with("water", 4);
  pipette.fill_viscosity = 0;
  CHECK_THROWS_WITH(axial_rod(pipette), Catch::Contains("fill_viscosity"));
  pipette = test::pipette_with("water", 4);
  pipette.columns = {{0, 1e-3, 1000, -1}};
  CHECK_THROWS_WITH(axial_rod(pipette), Catch::Contains("viscosity of a column"));
}
