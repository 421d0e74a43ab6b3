#pragma once

#include "mpm/membranes/membrane.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

enum class ZonaLaw { elastodamage, decohesion, elastic };

/// The zona pellucida, a spherical membrane.
struct Zona {
  double diameter;        ///< of the oocyte [m]
  double thickness;       ///< [m]
  int level;              ///< subdivisions of the icosahedron
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;   ///< [-]
  double density;         ///< [kg/m^3]
  ZonaLaw law;

  /// Mean distance of neighbouring points [m]: 1.107 R / 2^level, the icosahedron's edge 1.107 R
  /// (along the sphere) divided `level` times.
  double edge_length() const;
};

/// The section [zona], with the keys of its laws (material_tables.h). Complains of a zona that is
/// too thick and of incompatible options.
void declare_zona(Schema& schema);

/// The law of the zona with its parameters, in a grid of cubic cells of this edge [m].
mpm::MembraneLaw zona_law(const Configuration& study, double cell);

}  // namespace zona::studies
