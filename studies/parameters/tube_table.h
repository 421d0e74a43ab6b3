#pragma once

#include "studies/input/table_keys.h"

namespace zona::studies {

/// The glass tube of the injection pipette at its tip.
struct GlassTube {
  double outer_diameter;  ///< [m]
  double inner_diameter;  ///< of the bore [m]; zero for a solid rod
  double density;         ///< of the glass [kg/m^3]
};

/// Keys of the tube, in a section that is open. Complains of a bore that is not narrower than the
/// tube.
void declare_tube(Schema& schema, const std::string& section);

}  // namespace zona::studies
