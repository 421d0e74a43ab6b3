#include "studies/kinds/comparison/schema.h"

#include "studies/kinds/piercing/beam_drive.h"
#include "studies/kinds/piercing/fluid_tables.h"
#include "studies/kinds/piercing/geometry_checks.h"
#include "studies/kinds/piercing/grid_table.h"
#include "studies/kinds/piercing/measures.h"
#include "studies/kinds/piercing/motion_table.h"
#include "studies/kinds/piercing/plate_table.h"
#include "studies/kinds/piercing/scheme_tables.h"
#include "studies/kinds/piercing/tip_table.h"
#include "studies/kinds/piercing/zona_table.h"
#include "studies/parameters/fill_table.h"

namespace zona::studies {

namespace {

Schema make_schema() {
  Schema schema("comparison",
                "The same piercing with several fluids in the pipette, each driven by its own beam "
                "(sections 5.4 and 5.5 joined).");
  schema.section("fill", "What fills the bore of the pipette.");
  declare_fills(schema);
  declare_fill_place(schema);
  declare_beam_motion(schema);
  declare_beam_drive(schema);
  declare_grid(schema);
  declare_zona(schema);
  declare_fluids(schema);
  declare_tip(schema, "26441 kg/m^3");
  declare_plate(schema);
  declare_scheme(schema);
  declare_piercing_measures(schema);
  declare_piercing_run(schema);
  check_piercing_geometry(schema);
  return schema;
}

}  // namespace

const Schema& comparison_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
