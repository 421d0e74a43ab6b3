#include "studies/verification/case_list.h"

namespace zona::studies::verification {

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      impact(),         sod_tube(),
      piston(),           oblique_wave(), injection(),
      pipette_frequencies(), support_motion(), pipette_amplitude(), inflated_sphere(), hencky(),
      stokes(), couette(), 
  };
  return all;
}

}  // namespace zona::studies::verification
