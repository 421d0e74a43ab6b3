#include "studies/kinds/vibration/schema.h"

#include "studies/kinds/vibration/pulses_table.h"
#include "studies/parameters/bath_table.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/beam_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pulse_table.h"
#include "studies/parameters/tube_table.h"

namespace zona::studies {

namespace {

Schema make_schema() {
  Schema schema(
      "vibration",
      "How the tip of a pipette moves after a pulse at its support, by fluid and by pulse "
      "duration (section 5.5).");
  schema.section("pipette", "The injection pipette as a cantilever beam (Figure 5.24).");
  declare_tube(schema, "pipette");
  declare_beam(schema, "pipette", 20);
  declare_supports(schema, "pipette");

  schema.section("fill", "What fills the bore.");
  declare_fills(schema);
  declare_fill_place(schema);
  declare_columns(schema);
  declare_bath(schema);

  schema.section("pulse", "The motion of the support.");
  declare_pulse(schema, true);
  declare_pulses(schema);

  schema.section("time", "Time integration of the beam.");
  declare_beam_integration(schema, "time", IntegratorName::newmark);
  declare_vibration_output(schema);
  return schema;
}

}  // namespace

const Schema& vibration_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
