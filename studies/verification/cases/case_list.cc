#include "studies/verification/cases/case_list.h"

namespace zona::studies::verification {

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      impact(),
      bar_wave(),
      shock_tube(),
      sod_tube(),
      net(),
      gas_box(),
      material_points(),
      piston(),
      oblique_wave(),
      injection(),
      piercing_lateral(),
      piercing_axial(),
      piercing_numerics(),
      pipette_frequencies(),
      support_motion(),
      pipette_amplitude(),
      pipette_bath(),
      membrane_strip(),
      membrane_shear(),
      inflated_sphere(),
      hencky(),
      membrane_bending(),
      stokes(),
      couette(),
      standing_wave(),
      free_fall(),
      vortex(),
      drifting_bar(),
      hanging_bar(),
  };
  return all;
}

}  // namespace zona::studies::verification
