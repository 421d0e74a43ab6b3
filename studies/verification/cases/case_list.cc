#include "studies/verification/cases/case_list.h"

namespace zona::studies::verification {

const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> joined;
    for (const auto group :
         {solids, gas_dynamics, chapter_four, material_points, boundaries, injection, piercing,
          pipette, pipette_bath, membranes, flows, numerics}) {
      for (Case& c : group()) joined.push_back(std::move(c));
    }
    return joined;
  }();
  return all;
}

}  // namespace zona::studies::verification
