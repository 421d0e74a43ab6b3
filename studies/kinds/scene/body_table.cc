#include "studies/kinds/scene/body_table.h"

#include <fmt/format.h>

#include "studies/kinds/scene/fluid_table.h"
#include "studies/kinds/scene/motion_table.h"
#include "studies/kinds/scene/shape_table.h"
#include "studies/parameters/material_tables.h"
#include "studies/parameters/numerics_table.h"

namespace zona::studies {

namespace {

Condition of_material(const TableKeys<SceneBody>& keys, const std::vector<MaterialName>& names) {
  return keys.is(&SceneBody::material, kMaterialNames, names);
}

Condition of_law(const TableKeys<SceneBody>& keys, const std::vector<LawName>& names) {
  return keys.is(&SceneBody::law, kLawNames, names);
}

void declare_elasticity(TableKeys<SceneBody>& keys) {
  const Condition stiff = of_material(keys, {MaterialName::solid, MaterialName::membrane});
  keys.quantity("youngs_modulus", &SceneBody::youngs_modulus, "Pa", "")
      .without_default()
      .in("(0, 1e15]")
      .called("E")
      .only_where(stiff)
      .doc("Young's modulus.");
  keys.number("poisson_ratio", &SceneBody::poisson_ratio, 0)
      .without_default()
      .in("(-1, 0.5)")
      .called("nu")
      .only_where(stiff)
      .doc("Poisson's ratio.");
  keys.choice("law", &SceneBody::law, kLawNames)
      .only_where(stiff)
      .doc(
          "Linear elastic; elastodamage (5.7)-(5.11); von Mises plasticity (5.12)-(5.15); or von "
          "Mises and, where the flow localises, decohesion (5.32)-(5.42).");
}

void declare_laws(TableKeys<SceneBody>& keys) {
  const Condition separates = of_law(keys, {LawName::decohesion});
  declare_elastodamage(keys.schema(), keys.section(), {of_law(keys, {LawName::elastodamage})});
  declare_plasticity(keys.schema(), keys.section(), Plasticity::perfect(),
                     {of_law(keys, {LawName::von_mises, LawName::decohesion})});
  declare_separation(keys.schema(), keys.section(), {separates});
  const Condition membrane = of_material(keys, {MaterialName::membrane});
  keys.quantity("thickness", &SceneBody::thickness, "m", "")
      .without_default()
      .in("(0, 1e6]")
      .only_where(membrane)
      .doc("Initial thickness.");
  declare_kinematics(keys.schema(), keys.section(), {membrane});
  declare_one_way(keys.schema(), keys.section(), {membrane});
  declare_stress_update(keys.schema(), keys.section(),
                        {membrane, of_law(keys, {LawName::elastic})});
  declare_bifurcation(keys.schema(), keys.section(), {membrane, separates});
}

void check_material_fits_shape(const Table& body, const Complain& complain) {
  const ShapeName shape = body.value(&BodyShape::shape);
  const bool membrane = body.value(&SceneBody::material) == MaterialName::membrane;
  if (membrane == is_surface(shape)) return;
  const std::string word = word_for(shape_names(), shape);
  complain(body.leaf(&SceneBody::material),
           membrane ? fmt::format("a membrane is a surface, a {} is not; needs shape = \"sheet\", "
                                  "\"disc\" or \"icosphere\"",
                                  word)
                    : fmt::format("a {} is a surface; needs material = \"membrane\"", word));
}

}  // namespace

void declare_bodies(Schema& schema) {
  schema.list(
      "body",
      "Bodies of material points, each of one material. Bodies that share nodes of the grid "
      "stick to each other.",
      1, true);
  TableKeys<SceneBody> keys(schema, "body");
  declare_shape(schema, keys.section());
  keys.choice("material", &SceneBody::material, kMaterialNames)
      .doc(
          "A solid in rate form (3.41)-(3.42); an ideal gas (4.31); a liquid, that is a stiffened "
          "gas (5.1); a membrane (4.1); or a rigid body that moves as prescribed.");
  keys.formula("density", &SceneBody::density, "kg/m^3", {"x", "y", "z"}, "")
      .without_default()
      .in("(0, 1e9]")
      .called("rho")
      .doc("Initial density; constant for membranes and rigid bodies.");
  declare_elasticity(keys);
  declare_laws(keys);
  const Condition gas = of_material(keys, {MaterialName::gas});
  const Condition liquid = of_material(keys, {MaterialName::liquid});
  declare_scene_fluid(schema, keys.section(), gas, liquid);
  keys.boolean("average_volume_strain", &SceneBody::average_volume_strain, false)
      .only_where(of_material(keys, {MaterialName::solid, MaterialName::gas, MaterialName::liquid}))
      .doc(kAverageVolumeText);
  declare_body_motion(schema, keys.section(),
                      of_material(keys, {MaterialName::solid, MaterialName::gas,
                                         MaterialName::liquid, MaterialName::membrane}),
                      of_material(keys, {MaterialName::rigid}));
  schema.check_each(keys.section(), check_material_fits_shape);
}

const std::string& body_list(const Schema& schema) {
  return schema.binding<SceneBody>().section;
}

std::optional<Table> body_of_name(const Configuration& study, const std::string& name) {
  for (const Table& body : study.items<SceneBody>())
    if (body.name() == name) return body;
  return {};
}

}  // namespace zona::studies
