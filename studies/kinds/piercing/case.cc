#include "studies/kinds/piercing/case.h"

#include "coupling/prescribed_motion.h"
#include "coupling/tip_motion.h"
#include "coupling/tip_trace.h"
#include "studies/input/run_isolated.h"
#include "studies/input/with_key.h"
#include "studies/kinds/piercing/fluid_tables.h"
#include "studies/kinds/piercing/grid_table.h"
#include "studies/kinds/piercing/motion_table.h"
#include "studies/kinds/piercing/plate_table.h"
#include "studies/kinds/piercing/scheme_tables.h"
#include "studies/kinds/piercing/tip_table.h"
#include "studies/kinds/piercing/zona_table.h"
#include "studies/measures/profiles.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/material_tables.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"
#include "studies/parameters/time_step.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;

PiercingSetup::FluidRegion fluid_region(const FluidKeys& keys, mpm::EnergyIncrement increment) {
  return {keys.properties(increment), keys.points_per_cell};
}

PiercingSetup::Zona zona_setup(const Configuration& study) {
  const auto keys = study.read<Zona>();
  PiercingSetup::Zona zona;
  zona.diameter = keys.diameter;
  zona.level = keys.level;
  zona.membrane = {keys.density, keys.thickness, keys.youngs_modulus, keys.poisson_ratio,
                   study.value(&MembraneOptions::one_way)};
  zona.law = zona_law(study, study.value(&Grid::cell));
  zona.objective = study.value(&MembraneOptions::kinematics) == MembraneKinematics::objective;
  return zona;
}

PiercingSetup::Pipette pipette_setup(const Configuration& study, double fluid_density) {
  const auto tube = study.read<GlassTube>();
  const auto tip = study.read<Tip>();
  PiercingSetup::Pipette pipette;
  pipette.outer_diameter = tube.outer_diameter;
  pipette.inner_diameter = tube.inner_diameter;
  pipette.tip_length = tip.tip_length;
  pipette.points = tip.points;
  pipette.density = tip.density_with(fluid_density, tube);
  pipette.drive = tip.drive;
  return pipette;
}

PiercingSetup piercing_setup(const Configuration& study, double fluid_density) {
  const auto grid = study.read<Grid>();
  const auto plate = study.read<Plate>();
  const auto scheme = study.read<Scheme>();
  PiercingSetup setup;
  setup.cell = grid.cell;
  setup.domain = grid.domain;
  setup.zona = zona_setup(study);
  setup.cytoplasm = fluid_region(study.read<Cytoplasm>(), scheme.energy_increment);
  setup.medium = fluid_region(study.read<Medium>(), scheme.energy_increment);
  setup.pipette = pipette_setup(study, fluid_density);
  setup.plate = {plate.enabled, plate.side, plate.thickness_cells, plate.density};
  setup.interpolation = scheme.interpolation;
  setup.average_volume_strain = scheme.average_volume_strain;
  setup.numerics = study.read<mpm::Numerics>();
  setup.faces = PiercingSetup::all_faces(study.value(&Boundary::kind));
  return setup;
}

coupling::TipMotionOptions tip_motion_options(const Configuration& study, const Vector3d& axis) {
  return window_options(study.read<MotionWindow>(), simulation_end(study), axis);
}

/// The motion of the tip in the window of its history.
void drive_by(const coupling::TipMotion& motion, PiercingCase& c) {
  c.window_start = motion.start();
  c.setup.pipette.motion = motion;
}

/// The tip of a system, the beam or the rod, after a part of [pulse].
beam::TipHistory history_of(const Configuration& study, const beam::BeamSystem& system,
                            double part) {
  beam::SupportMotion pulse = support_motion(study);
  if (part != 1) pulse = beam::scaled(pulse, part);
  const auto integration = study.read<BeamIntegration>();
  return beam::integrate(system, pulse, integration.sampling(), integration.integrator_of(system));
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

void follow_beam(const Configuration& study, PiercingCase& c) {
  TipHistories tip = beam_tip_histories(study, c.fluid);
  drive_by(tip_motion(study, tip), c);
  if (tip.lateral) {
    c.bath_warnings = bath_warnings(study, *tip.lateral);
    c.tip_history = std::move(tip.lateral);
    c.axial_tip_history = std::move(tip.axial);
  } else {
    c.tip_history = std::move(tip.axial);
  }
  c.support_peak = beam::peak_displacement(support_motion(study));
}

void follow_trace(const Configuration& study, const Motion& motion, PiercingCase& c) {
  c.tip_history =
      with_key(study, study.key(&Motion::trace), [&] { return read_trace(motion.trace.string()); });
  const auto options = tip_motion_options(study, motion.direction());
  drive_by(with_key(study, window_key(study),
                    [&] { return coupling::TipMotion(*c.tip_history, options); }),
           c);
}

void set_motion(const Configuration& study, PiercingCase& c) {
  const auto motion = study.read<Motion>();
  const double ramp = study.value(&MotionWindow::ramp);
  switch (motion.kind) {
    case MotionKind::sine:
      c.setup.pipette.motion = coupling::rigid_motion(
          coupling::SineMotion{motion.peak(), motion.period, motion.direction(), ramp});
      break;
    case MotionKind::triangle:
      c.setup.pipette.motion = coupling::rigid_motion(
          coupling::TrianglePulse{motion.peak(), motion.duration, motion.direction(), ramp});
      break;
    case MotionKind::beam:
      follow_beam(study, c);
      break;
    case MotionKind::trace:
      follow_trace(study, motion, c);
      break;
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
  const beam::Pipette pipette = pipette_from(study, fluid);
  const PulseDirection part = study.read<Pulse>().direction();
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
  const auto model =
      with_key(study, study.key(&Grid::domain), [&] { return build_piercing(c.setup); });
  check_sections(study, model.grid, piercing_geometry(c.setup).egg_center);
  const TimeStep step = time_step(study, model, c.end);
  c.critical_step = step.critical;
  c.step = step.seconds;
  c.step_bound_by = step.binding;
  return c;
}

}  // namespace zona::studies
