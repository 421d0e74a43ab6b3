#include "studies/kinds/scene/schema.h"

#include "studies/kinds/scene/measures.h"
#include "studies/kinds/scene/parameters.h"

namespace zona::studies {

namespace {

Schema make_schema() {
  Schema schema("scene",
                "Plain material point method: a grid, bodies, loads and measurements, all in the "
                "file (chapters 3 and 4).");
  declare_scene_grid(schema);
  declare_scene_time(schema);
  declare_scene_bodies(schema);
  declare_scene_actions(schema);
  declare_scene_measures(schema);
  declare_scene_output(schema);
  check_scene(schema);
  return schema;
}

}  // namespace

const Schema& scene_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
