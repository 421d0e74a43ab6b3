#include "studies/kinds/material_point/material_table.h"

#include "studies/parameters/material_tables.h"

namespace zona::studies {

namespace {

const Words<PointGeometry> kGeometries{{"solid", PointGeometry::solid},
                                       {"membrane", PointGeometry::membrane}};

void check_update(const Configuration& study, const Complain& complain) {
  if (study.value(&MembraneOptions::stress_update) == StressUpdate::total) return;
  if (study.value(&PointMaterial::geometry) == PointGeometry::membrane &&
      study.value(&PointMaterial::law) == LawName::elastic)
    return;
  complain(study.key(&MembraneOptions::stress_update),
           "\"increments\" are for an elastic membrane; needs \"total\", or geometry = "
           "\"membrane\" and law = \"elastic\"");
}

}  // namespace

void declare_material(Schema& schema) {
  TableKeys<PointMaterial> keys(schema, "material", "Material of the point.");
  keys.choice("geometry", &PointMaterial::geometry, kGeometries)
      .doc("A point of a solid in three dimensions, or of a membrane in plane stress.");
  keys.choice("law", &PointMaterial::law, kLawNames)
      .doc(
          "Hooke's law; elastodamage (5.7)-(5.11); von Mises plasticity (5.12)-(5.15); or that "
          "and, where it localises, decohesion (5.32)-(5.42).");
  keys.quantity("youngs_modulus", &PointMaterial::youngs_modulus, "Pa", "17.9 kPa")
      .in("(0, 1e15]")
      .called("E")
      .doc("Young's modulus; the zona's by default (Table 5.2).");
  keys.number("poisson_ratio", &PointMaterial::poisson_ratio, 0.49)
      .in("(-1, 0.5)")
      .called("nu")
      .doc("Poisson's ratio; the zona's by default (Table 5.2).");
  declare_elastodamage(schema, keys.section());
  declare_plasticity(schema, keys.section(), Plasticity::zona());
  declare_separation(schema, keys.section());
  keys.quantity("cell", &PointMaterial::cell, "m", "6 um")
      .in("(0, 1e3]")
      .doc(
          "Edge of the cubic cell that the point stands in; gives the effective length L_e (5.35), "
          "the cell's volume over the area of the surface of decohesion in it.");
  declare_bifurcation(schema, keys.section());
  declare_one_way(schema, keys.section());
  declare_stress_update(schema, keys.section());
  schema.check(check_update);
}

}  // namespace zona::studies
