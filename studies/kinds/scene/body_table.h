#pragma once

#include <optional>
#include <string>

#include "studies/input/table_keys.h"
#include "studies/parameters/material_words.h"

namespace zona::studies {

/// Material of a [[body]]. Its shape is BodyShape; a fluid has SceneFluid, too, a solid or
/// membrane the keys of its law (material_tables.h), and all have BodyMotion.
struct SceneBody {
  MaterialName material;
  std::optional<Formula> density;  ///< initial, of the place [kg/m^3]; always given
  double youngs_modulus;           ///< of a solid or membrane [Pa]
  double poisson_ratio;            ///< of a solid or membrane [-]
  LawName law;                     ///< of a solid or membrane
  double thickness;                ///< initial, of a membrane [m]
  bool average_volume_strain;      ///< of bodies that have a volume and deform
};

/// The list [[body]]. Complains of materials that do not fit the shape.
void declare_bodies(Schema& schema);

/// The name of that list.
const std::string& body_list(const Schema& schema);

/// The table of the body of that name; empty when there is none.
std::optional<Table> body_of_name(const Configuration& study, const std::string& name);

}  // namespace zona::studies
