#pragma once

#include "studies/input/table_keys.h"

namespace zona::studies {

/// The holding pipette, a square plate behind the oocyte.
struct Plate {
  bool enabled;
  double side;          ///< [m]
  int thickness_cells;  ///< [cells]
  double density;       ///< [kg/m^3]

  double thickness(double cell) const { return enabled ? cell * thickness_cells : 0; }  ///< [m]
};

/// The section [plate].
void declare_plate(Schema& schema);

}  // namespace zona::studies
