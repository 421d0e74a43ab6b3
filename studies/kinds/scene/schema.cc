#include "studies/kinds/scene/schema.h"

#include "studies/kinds/scene/body_table.h"
#include "studies/kinds/scene/boundary_table.h"
#include "studies/kinds/scene/gravity_table.h"
#include "studies/kinds/scene/grid_table.h"
#include "studies/kinds/scene/hold_table.h"
#include "studies/kinds/scene/load_table.h"
#include "studies/kinds/scene/measures.h"
#include "studies/kinds/scene/time_table.h"
#include "studies/parameters/numerics_table.h"
#include "studies/parameters/output_table.h"
#include "studies/parameters/run_table.h"

namespace zona::studies {

namespace {

Schema make_schema() {
  Schema schema("scene",
                "Plain material point method: a grid, bodies, loads and measurements, all in the "
                "file (chapters 3 and 4).");
  declare_scene_grid(schema);
  declare_scene_boundary(schema);
  declare_gravity(schema);
  declare_scene_time(schema);
  schema.section("numerics", "Choices of the scheme; the defaults are the source's.");
  declare_numerics(schema);
  declare_bodies(schema);
  declare_holds(schema);
  declare_loads(schema);
  declare_scene_measures(schema);
  declare_output(schema, {"auto", "(0, 1e6]", "; \"auto\" makes 500 of them."},
                 {"auto", "(0, 1e6]", "; \"auto\" makes 20 of them."});
  declare_run(schema);
  return schema;
}

}  // namespace

const Schema& scene_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
