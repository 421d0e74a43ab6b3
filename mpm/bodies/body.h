#pragma once

#include <optional>
#include <string>
#include <variant>

#include "mpm/bodies/fluid_cells.h"
#include "mpm/grid/cell_index.h"
#include "mpm/materials/elastodamage_solid.h"
#include "mpm/materials/fluid.h"
#include "mpm/materials/prescribed.h"
#include "mpm/materials/von_mises_solid.h"
#include "mpm/membranes/membrane.h"
#include "mpm/points/state_visitor.h"

namespace zona::mpm {

/// Material of a body; the kernels select it once per body and brick, never per point.
using Material =
    std::variant<Fluid, LinearElastic, Solid<VonMises>, Solid<Elastodamage>, Membrane, Prescribed>;

/// True for materials whose volumetric strain can be averaged over cells: fluids and solids.
template <class M>
inline constexpr bool can_average_volume = M::has_stress && !std::is_same_v<M, Membrane>;

/// Material points of one material.
struct Body {
  std::string name;       ///< unique in a model
  MaterialPoints points;  ///< mass, position and velocity
  Material material;      ///< its constants and the state of its points
  CellIndex cells;        ///< points by cell; the solver builds it
  /// Fluids and 3D solids (B-bar): all points of the body in a cell get their volume-weighted mean
  /// volumetric strain rate and act on the nodes with their mean spherical stress. A cell then
  /// constrains the volume once, not once per point: a nearly incompressible body does not lock,
  /// and its points have no pressure modes that the grid cannot represent.
  bool average_volume_strain = false;
  /// Present for fluids whose pressure is implicit (Numerics); the solver makes it.
  std::optional<FluidCells> fluid_cells{};

  /// @{
  /// The material if it is of this type, else null.
  const Membrane* membrane() const { return std::get_if<Membrane>(&material); }
  const Prescribed* prescribed() const { return std::get_if<Prescribed>(&material); }
  /// @}
  /// True if `average_volume_strain` may be set.
  bool can_average() const;
  double wave_speed() const;        ///< of its material at the start [m/s]
  double shear_wave_speed() const;  ///< 0 without shear waves [m/s]
  /// Sorts the storage of the points into the order in which a step traverses them. Does nothing
  /// for membranes.
  void sort_points();
  /// Visits everything that a step changes and the next one needs, except the cells.
  void visit_state(StateVisitor& visitor);
};

}  // namespace zona::mpm
