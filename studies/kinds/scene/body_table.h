#pragma once

#include <optional>
#include <string>

#include "studies/input/table_keys.h"
#include "studies/parameters/material_words.h"

namespace zona::studies {

/// What a [[body]] is made of. Its shape is BodyShape; a fluid has SceneFluid, too, a solid or
/// membrane the keys of its law (material_tables.h), and all have BodyMotion.
struct SceneBody {
  MaterialName material;
  std::optional<Formula> density;  ///< at first, of the place [kg/m^3]; always given
  double youngs_modulus;           ///< of a solid or membrane [Pa]
  double poisson_ratio;            ///< of a solid or membrane [-]
  LawName law;                     ///< of a solid or membrane
  double thickness;                ///< of a membrane, at first [m]
  bool average_volume_strain;      ///< of what fills a volume and deforms
};

/// The list [[body]]. Complains of materials that do not fit the shape, and of what the tables of
/// its parts complain of.
void declare_bodies(Schema& schema);

/// The name of that list.
const std::string& body_list(const Schema& schema);

/// The table of the body of that name; empty when there is none.
std::optional<Table> body_of_name(const Configuration& study, const std::string& name);

}  // namespace zona::studies
