#include "beam/pipette/pipette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam/algebra/require.h"

namespace zona::beam {
namespace {

constexpr double min_slenderness = 10;
constexpr int max_elements = 1000;

void require_positive(const char* name, double value, const char* unit) {
  require(is_positive(value),
          fmt::format("pipette: {} is {} {}, but it must be finite and greater than 0; give a "
                      "positive value in SI units",
                      name, value, unit));
}

void require_non_negative(const char* name, double value, const char* unit) {
  require(is_non_negative(value),
          fmt::format("pipette: {} is {} {}, but it must be finite and at least 0; use 0 for none",
                      name, value, unit));
}

void check_diameters(const char* where, double outer, double inner) {
  require(inner < outer,
          fmt::format("pipette: inner_diameter{} is {} m, but it must be less than outer_diameter, "
                      "{} m; swap them or thicken the wall",
                      where, inner, outer));
}

void check_profile(const Pipette& pipette) {
  double before = -1;
  for (const Diameters& d : pipette.profile) {
    require(d.from_tip > before && d.from_tip <= pipette.length * (1 + 1e-9),
            fmt::format("pipette: the profile has a distance from the tip of {} m, but they must "
                        "increase from 0 and not exceed the length, {} m; sort it",
                        d.from_tip, pipette.length));
    require_positive("outer_diameter of the profile", d.outer, "m");
    require_non_negative("inner_diameter of the profile", d.inner, "m");
    check_diameters(" of the profile", d.outer, d.inner);
    before = d.from_tip;
  }
}

void check_columns(const Pipette& pipette) {
  for (const FillColumn& column : pipette.columns) {
    require(
        column.start >= 0 && column.end > column.start && std::isfinite(column.end),
        fmt::format("pipette: a column of fluid from {} to {} m from the tip, but it must begin "
                    "at 0 or more and end later than it begins",
                    column.start, column.end));
    require_non_negative("density of a column", column.density, "kg/m^3");
    require_positive("viscosity of a column", column.viscosity, "Pa s");
  }
}

void check_bath(const Bath& bath) {
  if (bath.model == BathModel::none) return;
  require_positive("density of the bath", bath.liquid.density, "kg/m^3");
  require_positive("viscosity of the bath", bath.liquid.viscosity, "Pa s");
  require_non_negative("immersed_length", bath.immersed_length, "m");
  require_positive("frequency of the bath", bath.frequency, "Hz");
  require_non_negative("drag_coefficient", bath.drag_coefficient, "");
}

double square(double x) {
  return x * x;
}

}  // namespace

void check(const Pipette& pipette) {
  require_positive("length", pipette.length, "m");
  require_positive("outer_diameter", pipette.outer_diameter, "m");
  require_non_negative("inner_diameter", pipette.inner_diameter, "m");
  require_positive("youngs_modulus", pipette.youngs_modulus, "Pa");
  require_positive("density", pipette.density, "kg/m^3");
  require_non_negative("fill_density", pipette.fill_density, "kg/m^3");
  require_positive("fill_viscosity", pipette.fill_viscosity, "Pa s");
  require_non_negative("damping_alpha", pipette.damping_alpha, "1/s");
  require_non_negative("damping_beta", pipette.damping_beta, "s");
  require_non_negative("loss_factor", pipette.loss_factor, "");
  require_positive("loss_frequency", pipette.loss_frequency, "Hz");
  check_diameters("", pipette.outer_diameter, pipette.inner_diameter);
  check_profile(pipette);
  check_columns(pipette);
  check_bath(pipette.bath);
  double widest = pipette.profile.empty() ? pipette.outer_diameter : 0;
  for (const Diameters& d : pipette.profile) widest = std::max(widest, d.outer);
  require(pipette.length >= min_slenderness * widest,
          fmt::format("pipette: length is {} m, but Euler-Bernoulli theory needs at least {} outer "
                      "diameters, {} m; lengthen the pipette or thin it",
                      pipette.length, min_slenderness, min_slenderness * widest));
  require(pipette.elements >= 1 && pipette.elements <= max_elements,
          fmt::format("pipette: elements is {}, but it must lie between 1 and {}; 20 is the "
                      "dissertation's choice, 80 err by about 1 %",
                      pipette.elements, max_elements));
}

Diameters diameters_at(const Pipette& pipette, double x) {
  const double from_tip = pipette.length - x;
  const auto& profile = pipette.profile;
  if (profile.empty()) return {from_tip, pipette.outer_diameter, pipette.inner_diameter};
  const auto next = std::find_if(profile.begin(), profile.end(),
                                 [&](const Diameters& d) { return d.from_tip >= from_tip; });
  if (next == profile.begin()) return {from_tip, next->outer, next->inner};
  const Diameters& before = *std::prev(next);
  if (next == profile.end()) return {from_tip, before.outer, before.inner};
  const double share = (from_tip - before.from_tip) / (next->from_tip - before.from_tip);
  return {from_tip, before.outer + share * (next->outer - before.outer),
          before.inner + share * (next->inner - before.inner)};
}

double glass_area(const Diameters& diameters) {
  return M_PI / 4 * (square(diameters.outer) - square(diameters.inner));
}

double second_moment_of_area(const Diameters& diameters) {
  return M_PI / 64 * (square(square(diameters.outer)) - square(square(diameters.inner)));
}

double mass_per_length(const Diameters& diameters, double glass_density, double fill_density) {
  const double outer = square(diameters.outer);
  const double bore = square(diameters.inner);
  return M_PI / 4 * ((outer - bore) * glass_density + bore * fill_density);
}

double second_moment_of_area(const Pipette& pipette) {
  return second_moment_of_area(Diameters{0, pipette.outer_diameter, pipette.inner_diameter});
}

double mass_per_length(const Pipette& pipette) {
  return mass_per_length({0, pipette.outer_diameter, pipette.inner_diameter}, pipette.density,
                         pipette.fill_density);
}

bool is_uniform(const Pipette& pipette) {
  return pipette.profile.empty() && pipette.columns.empty();
}

UniformBeam uniform_beam(const Pipette& pipette) {
  check(pipette);
  require(is_uniform(pipette),
          "pipette: its section changes along its length, so it is no uniform beam; leave profile "
          "and columns empty");
  return {pipette.length, pipette.youngs_modulus * second_moment_of_area(pipette),
          mass_per_length(pipette)};
}

Liquid fill_at(const Pipette& pipette, double x) {
  Liquid fill{pipette.fill_density, pipette.fill_viscosity};
  const double from_tip = pipette.length - x;
  for (const FillColumn& column : pipette.columns)
    if (from_tip >= column.start && from_tip < column.end)
      fill = {column.density, column.viscosity};
  return fill;
}

double immersed_from(const Pipette& pipette) {
  if (pipette.bath.model == BathModel::none) return pipette.length;
  return std::max(0., pipette.length - pipette.bath.immersed_length);
}

Section section_of(const Pipette& pipette) {
  check(pipette);
  Section section;
  if (is_uniform(pipette)) {
    section = section_of(uniform_beam(pipette));
  } else {
    section.length = pipette.length;
    section.flexural_rigidity = [pipette](double x) {
      return pipette.youngs_modulus * second_moment_of_area(diameters_at(pipette, x));
    };
    section.mass_per_length = [pipette](double x) {
      return mass_per_length(diameters_at(pipette, x), pipette.density,
                             fill_at(pipette, x).density);
    };
  }
  for (const Diameters& d : pipette.profile) section.breaks.push_back(pipette.length - d.from_tip);
  for (const FillColumn& column : pipette.columns) {
    section.breaks.push_back(pipette.length - column.start);
    section.breaks.push_back(pipette.length - column.end);
  }
  if (pipette.bath.model != BathModel::none) section.breaks.push_back(immersed_from(pipette));
  const auto outside = [&](double x) { return x <= 0 || x >= pipette.length; };
  section.breaks.erase(std::remove_if(section.breaks.begin(), section.breaks.end(), outside),
                       section.breaks.end());
  return section;
}

}  // namespace zona::beam
