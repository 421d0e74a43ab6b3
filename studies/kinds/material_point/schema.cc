#include "studies/kinds/material_point/schema.h"

#include "studies/kinds/material_point/material_table.h"
#include "studies/kinds/material_point/path_table.h"

namespace zona::studies {

namespace {

Schema make_schema() {
  Schema schema("material_point",
                "One point of a material, driven along a strain path: its stress, yield, peak, "
                "bifurcation and failure (section 5.3).");
  declare_material(schema);
  declare_path(schema);
  return schema;
}

}  // namespace

const Schema& material_point_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
