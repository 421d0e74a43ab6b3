#include "studies/kinds/piercing/schema.h"

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

bool is_driven_by_beam(const Configuration& study) {
  return study.value(&Motion::kind) == MotionKind::beam;
}

Schema make_schema() {
  Schema schema("piercing",
                "What the motion of an injection pipette does to the zona pellucida of a held "
                "oocyte (sections 5.2-5.4).");
  declare_motion(schema);
  declare_grid(schema);
  declare_zona(schema);
  declare_fluids(schema);
  declare_tip(schema, "auto");
  schema.section("fill", "What fills the bore of the pipette.");
  declare_fill(schema);
  schema.check_only_where(is_driven_by_beam);
  declare_fill_place(schema);
  declare_beam_drive(schema);
  schema.check_only_where({});
  declare_plate(schema);
  declare_scheme(schema);
  declare_piercing_measures(schema);
  declare_piercing_run(schema);
  check_piercing_geometry(schema);
  return schema;
}

}  // namespace

const Schema& piercing_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
