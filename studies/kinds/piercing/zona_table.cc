#include "studies/kinds/piercing/zona_table.h"

#include <fmt/format.h>

#include <cmath>

#include "studies/parameters/material_tables.h"

namespace zona::studies {

namespace {

const Words<ZonaLaw> kLaws{{"elastodamage", ZonaLaw::elastodamage},
                           {"decohesion", ZonaLaw::decohesion},
                           {"elastic", ZonaLaw::elastic}};

void check_thickness(const Configuration& study, const Complain& complain) {
  const double radius = study.value(&Zona::diameter) / 2;
  const double thickness = study.value(&Zona::thickness);
  if (thickness < radius) return;
  complain(study.key(&Zona::thickness),
           fmt::format("{:g} um is not thinner than the radius of {:g} um; reduce it or enlarge {}",
                       thickness * 1e6, radius * 1e6, study.key(&Zona::diameter)));
}

void check_law(const Configuration& study, const Complain& complain) {
  const ZonaLaw law = study.value(&Zona::law);
  const auto update = study.value(&MembraneOptions::stress_update);
  if (update == StressUpdate::total || law == ZonaLaw::elastic) return;
  complain(study.key(&MembraneOptions::stress_update),
           fmt::format("\"increments\" are for {} = \"elastic\", not for \"{}\"; needs \"total\"",
                       study.key(&Zona::law), word_for(kLaws, law)));
}

}  // namespace

void declare_zona(Schema& schema) {
  TableKeys<Zona> keys(schema, "zona", "The zona pellucida: a spherical membrane of triangles.");
  keys.quantity("diameter", &Zona::diameter, "m", "100 um")
      .in("(0, 0.01]")
      .doc("Diameter of the oocyte (5.4).");
  keys.quantity("thickness", &Zona::thickness, "m", "8 um")
      .in("(0, 1e-3]")
      .doc("Thickness of the membrane (5.4).");
  keys.integer("level", &Zona::level, 6)
      .in("[1, 9]")
      .doc(
          "Number of subdivisions of an icosahedron, each of which divides every triangle into "
          "four; 6 gives the 40962 points and 81920 triangles of 5.4.");
  keys.quantity("youngs_modulus", &Zona::youngs_modulus, "Pa", "17.9 kPa")
      .in("(0, 1e12]")
      .called("E")
      .doc("Young's modulus (Table 5.2).");
  keys.number("poisson_ratio", &Zona::poisson_ratio, 0.49)
      .in("(-1, 0.5)")
      .called("nu")
      .doc("Poisson's ratio (Table 5.2).");
  keys.quantity("density", &Zona::density, "kg/m^3", "1100 kg/m^3")
      .in("(0, 30000]")
      .called("rho")
      .doc("Density (5.4).");
  keys.choice("law", &Zona::law, kLaws)
      .doc(
          "Elastodamage (5.7)-(5.11); von Mises plasticity (5.12)-(5.15) and, where it localises, "
          "decohesion (5.32)-(5.42); or linear elastic.");
  declare_elastodamage(schema, "zona");
  declare_plasticity(schema, "zona", Plasticity::zona());
  declare_separation(schema, "zona");
  declare_bifurcation(schema, "zona");
  declare_kinematics(schema, "zona");
  declare_one_way(schema, "zona");
  declare_stress_update(schema, "zona");
  schema.check(check_thickness);
  schema.check(check_law);
}

double Zona::edge_length() const {
  constexpr double edge_of_icosahedron = 1.1071487177940904;  // atan(2), on the unit sphere
  return std::ldexp(edge_of_icosahedron * diameter / 2, -level);
}

mpm::MembraneLaw zona_law(const Configuration& study, double cell) {
  switch (study.value(&Zona::law)) {
    case ZonaLaw::elastodamage:
      return study.read<mpm::Elastodamage>();
    case ZonaLaw::elastic:
      return study.read<MembraneOptions>().elastic_law();
    case ZonaLaw::decohesion:
      break;
  }
  return plastic_law(study.table<Zona>(), true, Eigen::Vector3d::Constant(cell));
}

}  // namespace zona::studies
