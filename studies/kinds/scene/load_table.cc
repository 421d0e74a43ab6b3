#include "studies/kinds/scene/load_table.h"

#include <fmt/format.h>

#include "studies/kinds/scene/body_table.h"

namespace zona::studies {

namespace {

const Words<LoadKind> kLoadKinds{
    {"force", LoadKind::force}, {"traction", LoadKind::traction}, {"pressure", LoadKind::pressure}};

void check_load(const Table& load, const Complain& complain) {
  check_box<Load>(load, complain, false);
  const std::string& body_key = load.leaf(&Load::body);
  const auto body = body_of_name(load.study(), load.value(&Load::body));
  if (!body) return;
  const MaterialName material = body->value(&SceneBody::material);
  if (material == MaterialName::rigid) {
    complain(body_key, fmt::format("{} is rigid and moves as prescribed whatever acts on it; load "
                                   "another",
                                   body->name()));
  } else if (load.value(&Load::kind) == LoadKind::pressure && material != MaterialName::membrane) {
    complain(body_key,
             fmt::format("{} is no membrane; a pressure acts on membranes only", body->name()));
  }
}

}  // namespace

void declare_loads(Schema& schema) {
  schema.list("load", "Forces on bodies.", 0, false);
  TableKeys<Load> keys(schema, "load");
  keys.choice("kind", &Load::kind, kLoadKinds)
      .doc(
          "A total force or a traction times an area, on the points of a body that lie in a box at "
          "the start, shared by mass; or a pressure on a membrane.");
  keys.reference("body", &Load::body, body_list(schema)).doc("The body that is loaded.");
  const auto where = [&](const std::vector<LoadKind>& kinds) {
    return keys.is(&Load::kind, kLoadKinds, kinds);
  };
  declare_box(keys, "The box of the points that carry the force.",
              {where({LoadKind::force, LoadKind::traction})});
  keys.formulas("force", &Load::force, "N", {"t"}, {})
      .without_default()
      .exactly(3)
      .only_where(where({LoadKind::force}))
      .doc("Total force.");
  keys.formulas("traction", &Load::traction, "Pa", {"t"}, {})
      .without_default()
      .exactly(3)
      .only_where(where({LoadKind::traction}))
      .doc("Force per area.");
  keys.quantity("area", &Load::area, "m^2", "")
      .without_default()
      .in("(0, 1e12]")
      .only_where(where({LoadKind::traction}))
      .doc("Area that the traction acts on.");
  keys.formula("pressure", &Load::pressure, "Pa", {"t"}, "")
      .without_default()
      .only_where(where({LoadKind::pressure}))
      .doc("Pressure along the present normals of the triangles, positive outwards.");
  schema.check_each(keys.section(), check_load);
}

}  // namespace zona::studies
