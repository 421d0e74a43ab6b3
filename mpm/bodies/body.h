#pragma once

#include <string>
#include <variant>

#include "mpm/grid/cell_index.h"
#include "mpm/materials/elastodamage_solid.h"
#include "mpm/materials/fluid.h"
#include "mpm/materials/prescribed.h"
#include "mpm/materials/von_mises_solid.h"
#include "mpm/membranes/membrane.h"
#include "mpm/points/state_visitor.h"

namespace zona::mpm {

/// What a body is made of: chosen once per body and brick, never per point.
using Material =
    std::variant<Fluid, LinearElastic, Solid<VonMises>, Solid<Elastodamage>, Membrane, Prescribed>;

/// Whether a material has a volumetric strain that can be averaged over cells: fluids and solids.
template <class M>
inline constexpr bool can_average_volume = M::has_stress && !std::is_same_v<M, Membrane>;

/// Material points of one material.
struct Body {
  std::string name;       ///< unique in a model
  MaterialPoints points;  ///< what all points have
  Material material;      ///< its constants and what the points keep of it
  CellIndex cells;        ///< which points are where; the solver builds it
  /// Fluids and 3D solids: every point of a cell takes the mean volumetric strain rate of the
  /// body's points there, by volume, and they push with their mean spherical stress (B-bar). One
  /// cell then constrains the volume once, not once per point: an almost incompressible body does
  /// not lock, and its points do not hold pressures that the grid does not see.
  bool average_volume_strain = false;

  /// @{
  /// The material if it is of this type, else null.
  const Membrane* membrane() const { return std::get_if<Membrane>(&material); }
  const Prescribed* prescribed() const { return std::get_if<Prescribed>(&material); }
  /// @}
  /// Whether `average_volume_strain` may be set.
  bool can_average() const;
  double wave_speed() const;        ///< of its material at the start [m/s]
  double shear_wave_speed() const;  ///< 0 where there is none [m/s]
  /// Stores the points in the order in which the step walks them. Membranes stay as they are.
  void reorder_as_walked();
  /// Everything that a step changes and the next one needs, but the cells.
  void visit_state(StateVisitor& visitor);
};

}  // namespace zona::mpm
