#pragma once

#include "studies/input/table_keys.h"
#include "studies/parameters/material_words.h"

namespace zona::studies {

enum class PointGeometry { solid, membrane };

/// What the point is made of, beside the keys of its law (material_tables.h).
struct PointMaterial {
  PointGeometry geometry;
  LawName law;
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;   ///< [-]
  double cell;            ///< edge of the cubic cell that the point stands in [m]
};

/// The section [material]. Complains of what does not go together.
void declare_material(Schema& schema);

}  // namespace zona::studies
