#pragma once

#include <string>
#include <variant>

#include "mpm/cell_index.h"
#include "mpm/elastodamage_solid.h"
#include "mpm/fluid.h"
#include "mpm/membrane.h"
#include "mpm/prescribed.h"
#include "mpm/von_mises_solid.h"

namespace zona::mpm {

/// What a body is made of: chosen once per body and brick, never per point.
using Material =
    std::variant<Fluid, LinearElastic, Solid<VonMises>, Solid<Elastodamage>, Membrane, Prescribed>;

/// Material points of one material.
struct Body {
  std::string name;
  MaterialPoints points;
  Material material;
  CellIndex cells;

  const Membrane* membrane() const { return std::get_if<Membrane>(&material); }
  const Prescribed* prescribed() const { return std::get_if<Prescribed>(&material); }
  double wave_speed() const;
  double shear_wave_speed() const;
  /// Stores the points in the order in which the step walks them. Membranes stay as they are.
  void reorder_as_walked();
};

}  // namespace zona::mpm
