#include "studies/verification/case_list.h"

namespace zona::studies::verification {

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      pipette_frequencies(),
      support_motion(),
      pipette_amplitude(),
  };
  return all;
}

}  // namespace zona::studies::verification
