#pragma once

#include "studies/input/table_keys.h"
#include "studies/parameters/material_words.h"

namespace zona::studies {

enum class PointGeometry { solid, membrane };

/// Material of the point, besides the keys of its law (material_tables.h).
struct PointMaterial {
  PointGeometry geometry;
  LawName law;
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;   ///< [-]
  double cell;            ///< edge of the cubic cell that the point stands in [m]
};

/// The section [material]. Checks that the choices are compatible.
void declare_material(Schema& schema);

}  // namespace zona::studies
