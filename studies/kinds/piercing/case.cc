#include "studies/kinds/piercing/case.h"

#include "coupling/prescribed_motion.h"
#include "coupling/tip_motion.h"
#include "coupling/tip_trace.h"
#include "studies/input/run_isolated.h"
#include "studies/input/with_key.h"
#include "studies/kinds/piercing/values.h"
#include "studies/measures/profiles.h"
#include "studies/parameters/beam_parameters.h"
#include "studies/parameters/material_parameters.h"
#include "studies/parameters/numerics_parameters.h"
#include "studies/parameters/shared_parameters.h"
#include "studies/parameters/time_step.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;

PiercingSetup::FluidRegion fluid_region(const Configuration& study, const std::string& section) {
  const auto of = [&](const char* key) { return section + "." + key; };
  PiercingSetup::FluidRegion region{};
  region.fluid.density = study.quantity(of("density"));
  region.fluid.state = {study.number(of("grueneisen")), study.quantity(of("p_infinity"))};
  region.fluid.shear_viscosity = study.quantity(of("viscosity"));
  region.fluid.energy_increment = energy_increment_of(study.choice("numerics.energy_increment"));
  region.fluid.artificial_viscosity = {study.number(of("artificial_viscosity_quadratic")),
                                       study.number(of("artificial_viscosity_linear"))};
  region.points_per_cell = static_cast<int>(study.integer(of("points_per_cell")));
  return region;
}

mpm::MembraneLaw zona_law(const Configuration& study) {
  const std::string& law = study.choice("zona.law");
  if (law == "elastodamage") return elastodamage_from(study, "zona.");
  if (law == "elastic") {
    if (study.choice("zona.stress_update") == "increments") return mpm::IncrementalElastic{};
    return mpm::Elastic{};
  }
  mpm::VonMises plastic = von_mises_from(study, "zona.");
  plastic.decohesion =
      decohesion_from(study, "zona.", Vector3d::Constant(study.quantity("grid.cell")));
  plastic.decohesion->localization = localization_of(study.choice("zona.bifurcation"));
  return plastic;
}

PiercingSetup::Zona zona_setup(const Configuration& study) {
  PiercingSetup::Zona zona;
  zona.diameter = study.quantity("zona.diameter");
  zona.level = static_cast<int>(study.integer("zona.level"));
  zona.membrane = {study.quantity("zona.density"), study.quantity("zona.thickness"),
                   study.quantity("zona.youngs_modulus"), study.number("zona.poisson_ratio"),
                   one_way_of(study.choice("zona.one_way"))};
  zona.law = zona_law(study);
  zona.objective = study.choice("zona.kinematics") == "objective";
  return zona;
}

PiercingSetup::Pipette pipette_setup(const Configuration& study, double fluid_density) {
  PiercingSetup::Pipette pipette;
  pipette.outer_diameter = study.quantity("pipette.outer_diameter");
  pipette.inner_diameter = study.quantity("pipette.inner_diameter");
  pipette.tip_length = study.quantity("pipette.tip_length");
  const auto points = study.integers("pipette.points");
  for (int i = 0; i < 3; ++i) pipette.points[i] = static_cast<int>(points[i]);
  pipette.density = pipette_point_density(study, fluid_density);
  pipette.drive = study.choice("pipette.drive") == "nodes" ? mpm::Drive::nodes : mpm::Drive::points;
  return pipette;
}

PiercingSetup piercing_setup(const Configuration& study, double fluid_density) {
  PiercingSetup setup;
  setup.cell = study.quantity("grid.cell");
  setup.domain = study.quantity("grid.domain");
  setup.zona = zona_setup(study);
  setup.cytoplasm = fluid_region(study, "cytoplasm");
  setup.medium = fluid_region(study, "medium");
  setup.pipette = pipette_setup(study, fluid_density);
  setup.plate = {study.boolean("plate.enabled"), study.quantity("plate.side"),
                 static_cast<int>(study.integer("plate.thickness_cells")),
                 study.quantity("plate.density")};
  setup.interpolation = interpolation_of(study.choice("numerics.interpolation"));
  setup.average_volume_strain = study.boolean("numerics.average_volume_strain");
  setup.numerics = numerics_from(study);
  setup.faces = PiercingSetup::all_faces(face_condition(study.choice("boundary.kind")));
  return setup;
}

const Vector3d kLateral(0, 1, 0);
const Vector3d kAxial(-1, 0, 0);  ///< along the pipette into the egg

Vector3d motion_axis(const Configuration& study) {
  return study.choice("motion.axis") == "axial" ? kAxial : kLateral;
}

coupling::TipMotionOptions tip_motion_options(const Configuration& study, const Vector3d& axis) {
  coupling::TipMotionOptions options;
  if (!study.is_auto("motion.window_start")) options.start = study.quantity("motion.window_start");
  options.start_fraction = study.number("motion.auto_fraction");
  options.length = simulation_end(study);
  options.scale = study.number("motion.scale");
  options.axis = axis;
  options.ramp = study.quantity("motion.ramp");
  return options;
}

/// A window that does not fit is blamed on the key that sets it.
const char* window_key(const Configuration& study) {
  return study.is_auto("motion.window_start") ? "motion.window_length" : "motion.window_start";
}

/// The motion of the tip in the window of its history.
void drive_by(const coupling::TipMotion& motion, PiercingCase& c) {
  c.window_start = motion.start();
  c.setup.pipette.motion = motion;
}

/// The tip of a system, the beam or the rod, after a part of [pulse].
beam::TipHistory history_of(const Configuration& study, const beam::BeamSystem& system,
                            double part) {
  beam::SupportMotion pulse = support_motion(study, study.quantity("pulse.duration"));
  if (part != 1) pulse = beam::scaled(pulse, part);
  return beam::integrate(system, pulse, sampling_from(study, "beam"),
                         integrator_from(study, "beam", system));
}

/// libhdf5 crashes on some damaged files, so each is first read in another process.
beam::TipHistory read_trace(const std::string& path) {
  if (coupling::is_hdf5_trace(path)) {
    const std::string failure = run_isolated([&] { coupling::read_tip_trace(path); });
    if (!failure.empty()) {
      throw coupling::TraceError(path, 0, 0,
                                 "HDF5 failed to read it (" + failure +
                                     "); the file is damaged; write it anew, or as CSV");
    }
  }
  return coupling::read_tip_trace(path);
}

void set_motion(const Configuration& study, PiercingCase& c) {
  const std::string& kind = study.choice("motion.kind");
  const Vector3d axis = motion_axis(study);
  if (kind == "sine") {
    c.setup.pipette.motion = coupling::rigid_motion(
        coupling::SineMotion{motion_amplitude(study), study.quantity("motion.period"), axis,
                             study.quantity("motion.ramp")});
  } else if (kind == "triangle") {
    c.setup.pipette.motion = coupling::rigid_motion(
        coupling::TrianglePulse{motion_amplitude(study), study.quantity("motion.duration"), axis,
                                study.quantity("motion.ramp")});
  } else if (kind == "beam") {
    TipHistories tip = beam_tip_histories(study, c.fluid);
    drive_by(tip_motion(study, tip), c);
    if (tip.lateral) {
      c.bath_warnings = bath_warnings(study, "beam", *tip.lateral);
      c.tip_history = std::move(tip.lateral);
      c.axial_tip_history = std::move(tip.axial);
    } else {
      c.tip_history = std::move(tip.axial);
    }
    c.support_peak =
        beam::peak_displacement(support_motion(study, study.quantity("pulse.duration")));
  } else {
    c.tip_history = with_key(study, "motion.trace",
                             [&] { return read_trace(study.path("motion.trace").string()); });
    drive_by(with_key(study, window_key(study),
                      [&] {
                        return coupling::TipMotion(*c.tip_history, tip_motion_options(study, axis));
                      }),
             c);
  }
}

}  // namespace

coupling::TipMotion tip_motion(const Configuration& study, const TipHistories& tip) {
  return with_key(study, window_key(study), [&]() -> coupling::TipMotion {
    if (!tip.lateral) return {*tip.axial, tip_motion_options(study, kAxial)};
    const auto options = tip_motion_options(study, kLateral);
    if (!tip.axial) return {*tip.lateral, options};
    return {*tip.lateral, options, {*tip.axial, kAxial}};
  });
}

TipHistories beam_tip_histories(const Configuration& study, const beam::Fluid& fluid) {
  const beam::Pipette pipette = pipette_from(study, "beam", fluid);
  const PulseDirection part = pulse_direction(study);
  TipHistories tip;
  if (part.across != 0) tip.lateral = history_of(study, beam::cantilever(pipette), part.across);
  if (part.along != 0) tip.axial = history_of(study, beam::axial_rod(pipette), part.along);
  return tip;
}

PiercingCase make_piercing_case(const Configuration& study, const beam::Fluid& fluid) {
  PiercingCase c;
  c.fluid = fluid;
  c.setup = piercing_setup(study, fluid.density);
  c.end = simulation_end(study);
  set_motion(study, c);
  const auto model = with_key(study, "grid.domain", [&] { return build_piercing(c.setup); });
  check_sections(study, model.grid, piercing_geometry(c.setup).egg_center);
  const TimeStep step = time_step(study, model, c.end);
  c.critical_step = step.critical;
  c.step = step.seconds;
  return c;
}

}  // namespace zona::studies
