#include "studies/kinds/material_point/schema.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/kinds/material_point/path.h"
#include "studies/parameters/material_parameters.h"

namespace zona::studies {

namespace {

void declare_material(Schema& schema) {
  schema.section("material", "What the point is made of.");
  schema.choice("material.geometry", {"solid", "membrane"})
      .doc("A point of a solid in three dimensions, or of a membrane in plane stress.");
  schema.choice("material.law", {"elastic", "elastodamage", "von_mises", "decohesion"})
      .doc(
          "Hooke's law; elastodamage (5.7)-(5.11); von Mises plasticity (5.12)-(5.15); or that "
          "and, where it localises, decohesion (5.32)-(5.42).");
  schema.quantity("material.youngs_modulus", "Pa", "17.9 kPa")
      .in("(0, 1e15]")
      .called("E")
      .doc("Young's modulus; the zona's by default (Table 5.2).");
  schema.number("material.poisson_ratio", 0.49)
      .in("(-1, 0.5)")
      .called("nu")
      .doc("Poisson's ratio; the zona's by default (Table 5.2).");
  declare_elastodamage(schema, "material.");
  declare_von_mises(schema, "material.", zona_plasticity());
  declare_decohesion(schema, "material.");
  schema.quantity("material.cell", "m", "6 um")
      .in("(0, 1e3]")
      .doc(
          "Edge of the cubic cell that the point stands in; gives the effective length L_e (5.35), "
          "the cell's volume over the area of the surface of decohesion in it.");
  declare_localization(schema, "material.");
  declare_one_way(schema, "material.");
  declare_stress_update(schema, "material.");
}

void declare_path(Schema& schema) {
  schema.section("path",
                 "The strains that the point is led through, from zero. Each list holds the strain "
                 "at the end of each segment; a shorter list stays at its last value.");
  for (const std::string name : strain_components) {
    schema.numbers("path." + name, {0})
        .in("(-1, 1e3]")
        .doc(name[0] == name[1]
                 ? fmt::format("Normal strain {}; a stretch less one for a membrane.", name)
                 : fmt::format("Shear strain {}, the tensor component, half of the angle.", name));
  }
  schema.choices("path.free", {strain_components.begin(), strain_components.end()}, {})
      .or_none()
      .doc(
          "Components that are not driven: their strain is what frees them of stress. [\"yy\", "
          "\"zz\"] with the shears at zero is uniaxial stress.");
  schema.integer("path.steps", 200).in("[1, 1000000]").doc("Steps of each segment.");
}

bool is_membrane(const Configuration& study) {
  return study.choice("material.geometry") == "membrane";
}

void check_update(const Configuration& study, const Complain& complain) {
  if (study.choice("material.stress_update") == "total") return;
  if (is_membrane(study) && study.choice("material.law") == "elastic") return;
  complain("material.stress_update",
           "\"increments\" are for an elastic membrane; needs \"total\", or geometry = "
           "\"membrane\" and law = \"elastic\"");
}

/// Whether a strain of the path is set to anything but zero.
bool is_driven(const Configuration& study, const std::string& key) {
  const auto values = study.numbers(key);
  return std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
}

void check_components(const Configuration& study, const Complain& complain) {
  const auto free = study.texts("path.free");
  for (const std::string name : strain_components) {
    const bool is_free = std::find(free.begin(), free.end(), name) != free.end();
    const std::string key = "path." + name;
    const bool in_plane = name.find('z') == std::string::npos;
    if (is_membrane(study) && !in_plane && (is_free || is_driven(study, key))) {
      complain(is_free ? "path.free" : key,
               fmt::format("a membrane is in plane stress: it has no component {} to set; remove "
                           "it, or choose geometry = \"solid\"",
                           name));
    } else if (is_free && is_driven(study, key)) {
      complain(key,
               fmt::format("is given although {} is free; remove it here or from path.free", name));
    }
  }
}

void check_stretches(const Configuration& study, const Complain& complain) {
  if (!is_membrane(study)) return;
  for (const auto& e : path_strains(study)) {
    if ((1 + e[0]) * (1 + e[1]) > e[3] * e[3]) continue;
    complain("path.xy", fmt::format("a shear of {:g} with the stretches {:g} and {:g} turns the "
                                    "membrane inside out; needs a smaller one",
                                    e[3], 1 + e[0], 1 + e[1]));
    return;
  }
}

Schema make_schema() {
  Schema schema("material_point",
                "One point of a material, led along a path of strains: its stress, yield, peak, "
                "bifurcation and failure (section 5.3).");
  declare_material(schema);
  declare_path(schema);
  schema.check([](const Configuration& study, const Complain& complain) {
    check_von_mises("material.", study, complain);
  });
  schema.check(check_update);
  schema.check(check_components);
  schema.check(check_stretches);
  return schema;
}

}  // namespace

const Schema& material_point_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
