#include "studies/kinds/comparison/schema.h"

#include "studies/kinds/piercing/measures.h"
#include "studies/kinds/piercing/parameters.h"
#include "studies/parameters/shared_parameters.h"

namespace zona::studies {

namespace {

Schema make_schema() {
  Schema schema("comparison",
                "The same piercing with several fluids in the pipette, each driven by its own beam "
                "(sections 5.4 and 5.5 joined).");
  schema.section("fill", "What fills the bore of the pipette.");
  declare_fill_fluids(schema);
  declare_fill_place(schema);
  schema.section("motion", "How the tip of the injection pipette moves: always as its beam.");
  schema.choice("motion.kind", {"beam"}).doc("The tip of the beam in [beam].");
  schema.choice("motion.axis", {"lateral"})
      .doc("Has no effect: a beam takes its direction from pulse.angle.");
  schema.number("motion.scale", 1)
      .in("[-1e6, 1e6]")
      .doc("Factor on the displacement of the beam's tip.");
  declare_window(schema);
  declare_beam_drive(schema);
  declare_grid(schema);
  declare_zona(schema);
  declare_fluids(schema);
  declare_pipette_tip(schema, "26441 kg/m^3");
  declare_holding_plate(schema);
  declare_piercing_numerics(schema);
  declare_piercing_measures(schema);
  declare_piercing_run(schema);
  check_piercing_geometry(schema);
  schema.check([](const Configuration& study, const Complain& complain) {
    check_steps("beam.step", "beam.end", study, complain);
  });
  schema.check([](const Configuration& study, const Complain& complain) {
    check_beam_details("beam", "beam", study, complain);
  });
  schema.check(check_pulse);
  schema.check([](const Configuration& study, const Complain& complain) {
    check_distinct("fill.fluids", study, complain);
  });
  return schema;
}

}  // namespace

const Schema& comparison_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
