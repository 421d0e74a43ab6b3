#include "studies/kinds/piercing/schema.h"

#include <fmt/format.h>

#include "studies/kinds/piercing/measures.h"
#include "studies/kinds/piercing/parameters.h"
#include "studies/kinds/piercing/values.h"
#include "studies/parameters/shared_parameters.h"

namespace zona::studies {

namespace {

void declare_motion(Schema& schema) {
  schema.section("motion", "How the tip of the injection pipette moves.");
  schema.choice("motion.kind", {"sine", "triangle", "beam", "trace"})
      .doc(
          "A sine (5.4, lateral), a triangular pulse (5.4, axial), the tip of the beam in [beam] "
          "after the pulse in [pulse], or a recorded history.");
  schema.choice("motion.axis", {"lateral", "axial"})
      .doc(
          "Across the pipette, or along it towards the oocyte. A beam takes its direction from "
          "pulse.angle instead.");
  schema.quantity("motion.amplitude", "m", "auto")
      .in("[-1e-3, 1e-3]")
      .or_auto()
      .doc(
          "Amplitude of the sine or peak of the triangle; \"auto\" is 13.5 um for a sine and 1.8 "
          "um for a triangle (5.4).");
  schema.quantity("motion.period", "s", "100 us").in("(0, 1]").doc("Period of the sine (5.4).");
  schema.quantity("motion.duration", "s", "60 us")
      .in("(0, 1]")
      .doc("Duration of the triangle (5.4).");
  schema.file("motion.trace", "")
      .doc(
          "File of the recorded history, CSV or HDF5. The CSV begins with headings that carry "
          "units, "
          "such as `time [us],displacement [um]`. Needed by motion.kind = \"trace\".");
  schema.number("motion.scale", 1)
      .in("[-1e6, 1e6]")
      .doc("Factor on the displacement of a beam or a trace.");
  declare_window(schema);
}

void check_trace(const Configuration& study, const Complain& complain) {
  if (study.choice("motion.kind") != "trace" || !study.path("motion.trace").empty()) return;
  complain("motion.trace",
           "is missing; motion.kind = \"trace\" needs the path of a CSV file; write "
           "e.g. motion.trace = \"trace.csv\"");
}

void check_axis(const Configuration& study, const Complain& complain) {
  if (study.choice("motion.kind") != "beam" || study.choice("motion.axis") == "lateral") return;
  complain("motion.axis",
           "a beam's tip moves as its support does, whose direction is pulse.angle; leave "
           "motion.axis out, and write pulse.angle = \"0 deg\" for a motion along the pipette");
}

void check_beam_steps(const Configuration& study, const Complain& complain) {
  if (study.choice("motion.kind") != "beam") return;
  check_steps("beam.step", "beam.end", study, complain);
  check_beam_details("beam", "beam", study, complain);
  check_pulse(study, complain);
}

void check_ramp(const Configuration& study, const Complain& complain) {
  const double ramp = study.quantity("motion.ramp");
  const double end = simulation_end(study);
  if (ramp <= end) return;
  complain("motion.ramp", fmt::format("{:g} us are longer than the simulation of {:g} us; choose a "
                                      "shorter ramp",
                                      ramp * 1e6, end * 1e6));
}

void check_step(const Configuration& study, const Complain& complain) {
  if (study.is_auto("time.step")) return;
  const double step = study.quantity("time.step");
  const double end = simulation_end(study);
  if (step <= end && end / step <= 1e9) return;
  complain("time.step", fmt::format("{:g} ns do not fit a simulation of {:g} us; needs at most "
                                    "its length and at most 1e9 steps, or \"auto\"",
                                    step * 1e9, end * 1e6));
}

Schema make_schema() {
  Schema schema("piercing",
                "What the motion of an injection pipette does to the zona pellucida of a held "
                "oocyte (sections 5.2-5.4).");
  declare_motion(schema);
  declare_grid(schema);
  declare_zona(schema);
  declare_fluids(schema);
  declare_pipette_tip(schema, "auto");
  schema.section("fill", "What fills the bore of the pipette.");
  schema.quantity("fill.fluid", "kg/m^3", "mercury")
      .in("[0, 30000]")
      .or_named(fill_fluids())
      .doc("The fluid, by name (Table 5.7) or by density; adds mass to the tip and to the beam.");
  declare_fill_place(schema);
  declare_holding_plate(schema);
  declare_beam_drive(schema);
  declare_piercing_numerics(schema);
  declare_piercing_measures(schema);
  declare_piercing_run(schema);
  check_piercing_geometry(schema);
  schema.check(check_trace);
  schema.check(check_axis);
  schema.check(check_beam_steps);
  schema.check(check_ramp);
  schema.check(check_step);
  return schema;
}

}  // namespace

const Schema& piercing_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
