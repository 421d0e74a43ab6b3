#pragma once

#include <array>
#include <optional>
#include <string>

#include "mpm/materials/prescribed.h"
#include "studies/input/table_keys.h"
#include "studies/parameters/tube_table.h"

namespace zona::studies {

/// The tip of the injection pipette, besides its tube (GlassTube).
struct Tip {
  double tip_length;                    ///< that the simulation holds [m]
  std::array<int, 3> points;            ///< through the wall, around and along the tip
  std::optional<double> point_density;  ///< of the tip's points [kg/m^3]; empty: glass and fluid
  mpm::Drive drive;

  /// Density [kg/m^3] of the tip's points when a fluid of this density [kg/m^3] fills the bore:
  /// point_density, or the glass plus the fluid spread evenly over the glass.
  double density_with(double fluid_density, const GlassTube& tube) const;
};

/// The section [pipette]: tube and tip, with a default for point_density.
void declare_tip(Schema& schema, const std::string& point_density);

}  // namespace zona::studies
