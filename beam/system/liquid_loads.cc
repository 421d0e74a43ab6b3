#include <algorithm>

#include "beam/system/beam_system.h"

namespace zona::beam {

bool LiquidLoads::has_bath(BathModel model) const {
  return std::any_of(viscous.begin(), viscous.end(), [&](const ViscousLoad& load) {
    return load.flow != Flow::within && load.model == model;
  });
}

}  // namespace zona::beam
