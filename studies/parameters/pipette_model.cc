#include "studies/parameters/beam_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coupling/tip_trace.h"
#include "studies/input/table_file.h"
#include "studies/input/with_key.h"

namespace zona::studies {

namespace {

/// The diameters along the axis; empty where they are those of the tip everywhere.
std::vector<beam::Diameters> profile_from(const Configuration& study, const std::string& section,
                                          const beam::Pipette& pipette) {
  const auto file = study.path(section + ".profile");
  if (!file.empty()) {
    const auto table =
        read_table(file.string(), {{"distance", "m"}, {"outer", "m"}, {"inner", "m"}});
    std::vector<beam::Diameters> profile;
    for (std::size_t i = 0; i < table[0].size(); ++i)
      profile.push_back({table[0][i], table[1][i], table[2][i]});
    const auto differs = [](double a, double b) { return std::abs(a - b) > 1e-3 * b; };
    const beam::Diameters& tip = profile.front();
    if (differs(tip.outer, pipette.outer_diameter) || differs(tip.inner, pipette.inner_diameter))
      throw std::invalid_argument(fmt::format(
          "its tip has diameters of {:g} and {:g} um, but [pipette] says {:g} and {:g} um; make "
          "pipette.outer_diameter and pipette.inner_diameter those of the profile",
          tip.outer * 1e6, tip.inner * 1e6, pipette.outer_diameter * 1e6,
          pipette.inner_diameter * 1e6));
    return profile;
  }
  const bool keeps_outer = study.is_auto(section + ".shoulder_outer_diameter");
  const bool keeps_ratio = study.is_auto(section + ".shoulder_inner_diameter");
  if (keeps_outer && keeps_ratio) return {};
  const double outer =
      keeps_outer ? pipette.outer_diameter : study.quantity(section + ".shoulder_outer_diameter");
  const double inner = keeps_ratio ? outer * pipette.inner_diameter / pipette.outer_diameter
                                   : study.quantity(section + ".shoulder_inner_diameter");
  return {{0, pipette.outer_diameter, pipette.inner_diameter}, {pipette.length, outer, inner}};
}

/// `end`, or the support for "auto".
double end_of(const Configuration& study, const std::string& key, double length) {
  return study.is_auto(key) ? length : study.quantity(key);
}

/// The viscosity that stands under a key, for "auto" that of the fluid by this name, or water's.
double viscosity_of(const Configuration& study, const std::string& key, const std::string& fluid) {
  if (!study.is_auto(key)) return study.quantity(key);
  for (const beam::Fluid& known : beam::named_fluids())
    if (known.name == fluid) return known.viscosity;
  return beam::Liquid{}.viscosity;
}

void fill(const Configuration& study, const beam::Fluid& fluid, beam::Pipette& pipette) {
  const double start = study.quantity("fill.start");
  const double end = end_of(study, "fill.end", pipette.length);
  if (start == 0 && end >= pipette.length) {
    pipette.fill_density = fluid.density;
    pipette.fill_viscosity = fluid.viscosity;
  } else {
    pipette.columns.push_back({start, end, fluid.density, fluid.viscosity});
  }
  for (const Table& column : study.items("column"))
    pipette.columns.push_back({column.quantity("start"),
                               end_of(study, column.key("end"), pipette.length),
                               column.quantity("fluid"),
                               viscosity_of(study, column.key("viscosity"), column.text("fluid"))});
}

beam::Bath bath_from(const Configuration& study) {
  beam::Bath bath;
  const std::string& model = study.choice("bath.model");
  if (model == "frequency") bath.model = beam::BathModel::frequency;
  if (model == "per_mode") bath.model = beam::BathModel::per_mode;
  if (model == "constant") bath.model = beam::BathModel::constant;
  bath.liquid = {study.quantity("bath.density"), study.quantity("bath.viscosity")};
  bath.immersed_length = study.quantity("bath.immersed_length");
  bath.frequency = study.quantity("bath.frequency");
  bath.drag_coefficient = study.number("bath.drag_coefficient");
  return bath;
}

}  // namespace

std::vector<beam::Fluid> fills_of(const Configuration& study) {
  std::vector<beam::Fluid> fills;
  const auto add = [&](const std::string& name, double density) {
    fills.push_back({name, density, viscosity_of(study, "fill.viscosity", name), ""});
  };
  if (study.schema().find("fill.fluid") != nullptr) {
    add(study.text("fill.fluid"), study.quantity("fill.fluid"));
    return fills;
  }
  const auto names = study.texts("fill.fluids");
  const auto densities = study.quantities("fill.fluids");
  for (std::size_t i = 0; i < names.size(); ++i) add(names[i], densities[i]);
  return fills;
}

beam::Pipette pipette_from(const Configuration& study, const std::string& section,
                           const beam::Fluid& fluid) {
  beam::Pipette pipette;
  pipette.length = study.quantity(section + ".length");
  pipette.outer_diameter = study.quantity("pipette.outer_diameter");
  pipette.inner_diameter = study.quantity("pipette.inner_diameter");
  pipette.youngs_modulus = study.quantity(section + ".youngs_modulus");
  pipette.density = study.quantity("pipette.density");
  pipette.elements = static_cast<int>(study.integer(section + ".elements"));
  pipette.damping_alpha = study.quantity(section + ".rayleigh_alpha");
  pipette.damping_beta = study.quantity(section + ".rayleigh_beta");
  pipette.loss_factor = study.number(section + ".loss_factor");
  pipette.loss_frequency = study.quantity(section + ".loss_frequency");
  pipette.profile =
      with_key(study, section + ".profile", [&] { return profile_from(study, section, pipette); });
  fill(study, fluid, pipette);
  pipette.bath = bath_from(study);
  try {
    beam::check(pipette);
  } catch (const std::invalid_argument& error) {
    throw InputError(study.problem(section + ".length", error.what()));
  }
  return pipette;
}

double support_peak(const Configuration& study) {
  if (!study.is_auto("pulse.peak")) return study.quantity("pulse.peak");
  return study.quantity("pulse.voltage") * study.quantity("pulse.gain");
}

std::string calibration_text(const Configuration& study) {
  if (!study.is_auto("pulse.peak")) return "";
  const double peak = support_peak(study);
  const double spread = study.number("pulse.gain_uncertainty");
  return fmt::format(
      "support: {:g} V times {:g} um/V is {:.4g} um, by the gain's uncertainty {:.4g} to {:.4g} "
      "um; "
      "displacements scale with it\n",
      study.quantity("pulse.voltage"), study.quantity("pulse.gain") * 1e6, peak * 1e6,
      peak * (1 - spread) * 1e6, peak * (1 + spread) * 1e6);
}

std::vector<std::string> bath_warnings(const Configuration& study, const std::string& section,
                                       const beam::TipHistory& history) {
  std::vector<std::string> warnings;
  if (study.choice("bath.model") == "none") return warnings;
  const double diameter = study.quantity("pipette.outer_diameter");
  const double immersed =
      std::min(study.quantity("bath.immersed_length"), study.quantity(section + ".length"));
  const double viscosity = study.quantity("bath.viscosity") / study.quantity("bath.density");
  const double peak = std::abs(history.displacement[beam::index_of_peak(history.displacement)]);
  const double speed = std::abs(history.velocity[beam::index_of_peak(history.velocity)]);
  if (immersed == 0) return warnings;
  if (peak > 0.1 * diameter)
    warnings.push_back(fmt::format(
        "the tip moves by {:.2g} of its diameter; the bath's linear load holds for less than about "
        "0.1, beyond it drag grows (bath.drag_coefficient)",
        peak / diameter));
  if (speed * diameter / viscosity > 5)
    warnings.push_back(fmt::format(
        "the Reynolds number of the tip's speed, {:.2g} m/s, is {:.2g}; above about 5 the "
        "flow separates, which the linear load does not know",
        speed, speed * diameter / viscosity));
  if (immersed < 10 * diameter)
    warnings.push_back(fmt::format(
        "{:.3g} um are immersed, {:.2g} diameters; the load of a long cylinder wants 10",
        immersed * 1e6, immersed / diameter));
  if (!study.is_auto("bath.wall_distance")) {
    // Stokes' layer at the frequency of the tip's swing.
    const double layer = std::sqrt(2 * viscosity * peak / speed);
    const double wanted = 5 * (layer + diameter / 2);
    const double wall = study.quantity("bath.wall_distance");
    if (wall < wanted)
      warnings.push_back(fmt::format(
          "the wall is {:.3g} um away; nearer than about {:.3g} um, five times radius and viscous "
          "layer, it adds mass and drag that are not counted",
          wall * 1e6, wanted * 1e6));
  }
  return warnings;
}

beam::SupportMotion support_motion(const Configuration& study, double duration) {
  const std::string& shape = study.choice("pulse.shape");
  const double peak = support_peak(study);
  beam::SupportMotion pulse;
  if (shape == "trapezoid") {
    pulse = beam::trapezoidal_pulse(peak, duration, duration * study.number("pulse.rise_fraction"));
  } else if (shape == "half_sine") {
    pulse = beam::half_sine_pulse(peak, duration);
  } else if (shape == "trace") {
    pulse = with_key(study, "pulse.trace", [&] {
      const auto trace = coupling::read_tip_trace_csv(study.path("pulse.trace").string());
      const beam::SupportMotion motion = beam::SampledMotion{trace.time, trace.displacement};
      beam::check(motion);
      return motion;
    });
  } else {
    pulse = beam::triangular_pulse(peak, duration);
  }
  const int count = static_cast<int>(study.integer("pulse.count"));
  if (count == 1) return pulse;
  return with_key(study, "pulse.repetition_rate", [&] {
    return beam::pulse_train(pulse, count, 1 / study.quantity("pulse.repetition_rate"));
  });
}

beam::Sampling sampling_from(const Configuration& study, const std::string& section) {
  return {study.quantity(section + ".end"), study.quantity(section + ".step")};
}

beam::Integrator integrator_from(const Configuration& study, const std::string& section,
                                 const beam::BeamSystem& system) {
  const std::string& name = study.choice(section + ".integrator");
  if (name == "modal") {
    // A bore's fluid at each mode's own frequency would be a poor guess.
    const auto& loads = system.liquids.viscous;
    const bool is_filled_rod = std::any_of(loads.begin(), loads.end(), [](const auto& load) {
      return load.flow == beam::Flow::within;
    });
    if (is_filled_rod && !system.liquids.has_bath(beam::BathModel::per_mode))
      return beam::Transform{};
    return beam::Modal{};
  }
  if (name == "transform") return beam::Transform{};
  if (name == "newmark") return beam::Newmark{};
  // Maxwell elements relax within nanoseconds.
  const bool is_stiff = system.damping_beta > 0 || system.loss_factor > 0 || system.liquids.act();
  const auto method = is_stiff ? beam::RungeKutta::implicit_5 : beam::RungeKutta::explicit_8;
  return beam::Arkode{study.number(section + ".relative_tolerance"),
                      study.quantity(section + ".absolute_tolerance"), method};
}

}  // namespace zona::studies
