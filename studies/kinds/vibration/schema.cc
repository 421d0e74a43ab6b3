#include "studies/kinds/vibration/schema.h"

#include "studies/parameters/shared_parameters.h"

namespace zona::studies {

namespace {

void check_direction(const Configuration& study, const Complain& complain) {
  if (pulse_direction(study).along == 0) return;
  if (study.choice("pipette.supports") == "pinned")
    complain("pulse.angle",
             "a simply supported beam is moved across itself; needs \"90 deg\", or "
             "pipette.supports = \"clamped\"");
}

Schema make_schema() {
  Schema schema(
      "vibration",
      "How the tip of a pipette moves after a pulse at its support, by fluid and by pulse "
      "duration (section 5.5).");
  schema.section("pipette", "The injection pipette as a cantilever beam (Figure 5.24).");
  declare_pipette_bore(schema, "pipette");
  schema.quantity("pipette.density", "kg/m^3", "2300 kg/m^3")
      .in("(0, 30000]")
      .doc("Density of the glass (5.4); with the fluid it gives the mass per length of Table 5.5.");
  declare_beam(schema, "pipette", 20);
  schema.choice("pipette.supports", {"clamped", "pinned"})
      .doc(
          "Clamped at the moving support and free at the tip, which is observed (Figure 5.24); or "
          "simply supported at both ends, the left one moving, observed at the centre (Figure "
          "5.25).");

  schema.section("fill", "What fills the bore.");
  declare_fill_fluids(schema);
  declare_fill_place(schema);
  declare_columns(schema);
  declare_bath(schema);

  schema.section("pulse", "The motion of the support.");
  declare_pulse_form(schema, {"triangular", "trapezoid", "half_sine", "trace", "sine"});
  schema
      .quantities("pulse.durations", "s",
                  {"60 us", "120 us", "180 us", "240 us", "300 us", "360 us", "420 us", "480 us",
                   "540 us", "600 us"})
      .in("(0, 1]")
      .doc("Durations of a triangular pulse, one run each (5.5: 60 to 600 us in steps of 60 us).");
  schema
      .quantities("pulse.angular_frequencies", "rad/s",
                  {"5200 rad/s", "52000 rad/s", "208000 rad/s"})
      .in("(0, 1e9]")
      .doc("Angular frequencies of a sine, one run each (Figure 5.26).");

  schema.section("time", "Time integration of the beam.");
  declare_beam_integration(schema, "time", {"newmark", "arkode", "modal", "transform"});

  schema.section("output", "What is written into the run directory.");
  schema.boolean("output.history", true)
      .doc(
          "Whether the tip's motion of every run is kept, in history.csv. Sweeps of thousands of "
          "runs want only amplitudes.csv, which is always written.");

  schema.boolean("output.sensitivities", false)
      .doc(
          "Whether the derivatives of each run's amplitude, peak velocity and ring-down by every "
          "input "
          "are computed, into sensitivities.csv and summary.json. Exact (forward sensitivity "
          "analysis), "
          "for pulses without a quadratic drag.");
  schema.check([](const Configuration& study, const Complain& complain) {
    if (!study.boolean("output.sensitivities")) return;
    if (study.choice("pulse.shape") == "sine" || study.choice("bath.model") == "per_mode" ||
        study.number("bath.drag_coefficient") > 0)
      complain(
          "output.sensitivities",
          "takes a pulse (no sine), bath.model \"none\", \"frequency\" or \"constant\", and no "
          "quadratic drag; set it to false, or change these");
  });
  schema.check(check_direction);
  schema.check([](const Configuration& study, const Complain& complain) {
    check_bore("pipette", study, complain);
  });
  schema.check([](const Configuration& study, const Complain& complain) {
    check_steps("time.step", "time.end", study, complain);
  });
  schema.check([](const Configuration& study, const Complain& complain) {
    check_beam_details("pipette", "time", study, complain);
  });
  schema.check(check_pulse);
  schema.check([](const Configuration& study, const Complain& complain) {
    check_distinct("fill.fluids", study, complain);
  });
  schema.check([](const Configuration& study, const Complain& complain) {
    check_distinct("pulse.durations", study, complain);
  });
  schema.check([](const Configuration& study, const Complain& complain) {
    check_distinct("pulse.angular_frequencies", study, complain);
  });
  return schema;
}

}  // namespace

const Schema& vibration_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
