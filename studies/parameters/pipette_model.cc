#include "studies/parameters/pipette_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mpm/files/csv_table.h"
#include "studies/input/units.h"
#include "studies/input/with_key.h"
#include "studies/parameters/bath_table.h"
#include "studies/parameters/beam_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/tube_table.h"

namespace zona::studies {

namespace {

std::vector<beam::Diameters> profile_in_file(const std::filesystem::path& file,
                                             const GlassTube& tube) {
  const auto length = [](const std::string& unit) {
    return mpm::UnitScale{parse_quantity("1 " + unit, "m"), 1};
  };
  const auto table = mpm::CsvTable::read(
      file.string(), {{"distance", "m", length}, {"outer", "m", length}, {"inner", "m", length}});
  std::vector<beam::Diameters> profile;
  for (std::size_t i = 0; i < table.rows(); ++i)
    profile.push_back({table["distance"][i], table["outer"][i], table["inner"][i]});
  const auto differs = [](double a, double b) { return std::abs(a - b) > 1e-3 * b; };
  const beam::Diameters& tip = profile.front();
  if (differs(tip.outer, tube.outer_diameter) || differs(tip.inner, tube.inner_diameter))
    throw std::invalid_argument(fmt::format(
        "its tip has diameters of {:g} and {:g} um, but [pipette] says {:g} and {:g} um; make "
        "pipette.outer_diameter and pipette.inner_diameter those of the profile",
        tip.outer * 1e6, tip.inner * 1e6, tube.outer_diameter * 1e6, tube.inner_diameter * 1e6));
  return profile;
}

/// The diameters along the axis; empty where they are those of the tip everywhere.
std::vector<beam::Diameters> profile_of(const Beam& beam, const GlassTube& tube) {
  if (!beam.profile.empty()) return profile_in_file(beam.profile, tube);
  if (!beam.shoulder_outer_diameter && !beam.shoulder_inner_diameter) return {};
  const double outer = beam.shoulder_outer_diameter.value_or(tube.outer_diameter);
  const double inner =
      beam.shoulder_inner_diameter.value_or(outer * tube.inner_diameter / tube.outer_diameter);
  return {{0, tube.outer_diameter, tube.inner_diameter}, {beam.length, outer, inner}};
}

void fill(const Configuration& study, const beam::Fluid& fluid, beam::Pipette& pipette) {
  const auto place = study.read<FillPlace>();
  const double end = place.end.value_or(pipette.length);
  if (place.start == 0 && end >= pipette.length) {
    pipette.fill_density = fluid.density;
    pipette.fill_viscosity = fluid.viscosity;
  } else {
    pipette.columns.push_back({place.start, end, fluid.density, fluid.viscosity});
  }
  for (const FluidColumn& column : study.read_all<FluidColumn>())
    pipette.columns.push_back({column.start, column.end.value_or(pipette.length),
                               column.fluid.value,
                               viscosity_of(column.viscosity, column.fluid.text)});
}

}  // namespace

beam::Pipette pipette_from(const Configuration& study, const beam::Fluid& fluid) {
  const auto tube = study.read<GlassTube>();
  const auto beam = study.read<Beam>();
  beam::Pipette pipette;
  pipette.length = beam.length;
  pipette.outer_diameter = tube.outer_diameter;
  pipette.inner_diameter = tube.inner_diameter;
  pipette.youngs_modulus = beam.youngs_modulus;
  pipette.density = tube.density;
  pipette.elements = beam.elements;
  pipette.damping_alpha = beam.rayleigh_alpha;
  pipette.damping_beta = beam.rayleigh_beta;
  pipette.loss_factor = beam.loss_factor;
  pipette.loss_frequency = beam.loss_frequency;
  pipette.profile =
      with_key(study, study.key(&Beam::profile), [&] { return profile_of(beam, tube); });
  fill(study, fluid, pipette);
  pipette.bath = study.read<Bath>().bath();
  try {
    beam::check(pipette);
  } catch (const std::invalid_argument& error) {
    throw InputError(study.problem(&Beam::length, error.what()));
  }
  return pipette;
}

std::vector<std::string> bath_warnings(const Configuration& study,
                                       const beam::TipHistory& history) {
  std::vector<std::string> warnings;
  const auto bath = study.read<Bath>();
  if (bath.model == beam::BathModel::none) return warnings;
  const double diameter = study.value(&GlassTube::outer_diameter);
  const double immersed = std::min(bath.immersed_length, study.value(&Beam::length));
  const double viscosity = bath.viscosity / bath.density;
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
        "flow separates, which the linear load ignores",
        speed, speed * diameter / viscosity));
  if (immersed < 10 * diameter)
    warnings.push_back(fmt::format(
        "{:.3g} um are immersed, {:.2g} diameters; the load of a long cylinder needs 10",
        immersed * 1e6, immersed / diameter));
  if (bath.wall_distance) {
    // Stokes' layer at the frequency of the tip's swing.
    const double layer = std::sqrt(2 * viscosity * peak / speed);
    const double wanted = 5 * (layer + diameter / 2);
    const double wall = *bath.wall_distance;
    if (wall < wanted)
      warnings.push_back(fmt::format(
          "the wall is {:.3g} um away; nearer than about {:.3g} um, five times radius and viscous "
          "layer, it adds mass and drag that are not counted",
          wall * 1e6, wanted * 1e6));
  }
  return warnings;
}

}  // namespace zona::studies
