#include "beam/pipette.h"

#include <fmt/format.h>

#include <cmath>

#include "beam/require.h"

namespace zona::beam {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSlenderness = 10;
constexpr int kMostElements = 1000;

void require_positive(const char* name, double value, const char* unit) {
  require(is_positive(value),
          fmt::format("pipette: {} is {} {}, but it must be finite and greater than 0; give a "
                      "positive value in SI units",
                      name, value, unit));
}

void require_not_negative(const char* name, double value, const char* unit) {
  require(is_not_negative(value),
          fmt::format("pipette: {} is {} {}, but it must be finite and at least 0; use 0 for none",
                      name, value, unit));
}

}  // namespace

void check(const Pipette& pipette) {
  require_positive("length", pipette.length, "m");
  require_positive("outer_diameter", pipette.outer_diameter, "m");
  require_not_negative("inner_diameter", pipette.inner_diameter, "m");
  require_positive("youngs_modulus", pipette.youngs_modulus, "Pa");
  require_positive("density", pipette.density, "kg/m^3");
  require_not_negative("fill_density", pipette.fill_density, "kg/m^3");
  require_not_negative("damping_alpha", pipette.damping_alpha, "1/s");
  require_not_negative("damping_beta", pipette.damping_beta, "s");
  require(pipette.inner_diameter < pipette.outer_diameter,
          fmt::format("pipette: inner_diameter is {} m, but it must be less than outer_diameter, "
                      "{} m; swap them or thicken the wall",
                      pipette.inner_diameter, pipette.outer_diameter));
  require(pipette.length >= kSlenderness * pipette.outer_diameter,
          fmt::format("pipette: length is {} m, but Euler-Bernoulli theory needs at least {} outer "
                      "diameters, {} m; lengthen the pipette or thin it",
                      pipette.length, kSlenderness, kSlenderness * pipette.outer_diameter));
  require(pipette.elements >= 1 && pipette.elements <= kMostElements,
          fmt::format("pipette: elements is {}, but it must lie between 1 and {}; 20 is the "
                      "dissertation's choice, 80 err by about 1 %",
                      pipette.elements, kMostElements));
}

double second_moment_of_area(const Pipette& pipette) {
  return kPi / 64 * (std::pow(pipette.outer_diameter, 4) - std::pow(pipette.inner_diameter, 4));
}

double mass_per_length(const Pipette& pipette) {
  const double outer = pipette.outer_diameter * pipette.outer_diameter;
  const double bore = pipette.inner_diameter * pipette.inner_diameter;
  return kPi / 4 * ((outer - bore) * pipette.density + bore * pipette.fill_density);
}

UniformBeam uniform_beam(const Pipette& pipette) {
  check(pipette);
  return {pipette.length, pipette.youngs_modulus * second_moment_of_area(pipette),
          mass_per_length(pipette)};
}

}  // namespace zona::beam
