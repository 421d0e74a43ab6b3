#pragma once

#include <string>
#include <vector>

#include "studies/kinds/search/case_store.h"
#include "studies/kinds/search/tip_stage.h"

namespace zona::studies::search {

/// A piercing of a design that the second optimiser tried.
struct Trial {
  std::size_t start = 0;  ///< number of the design that it set out from
  Design design;
  Values values;  ///< of tip and oocyte; without the oocyte's where the piercing failed
  double cost = 0;
};

/// Measures of the tip and, where the piercing has come to results, of the oocyte.
Values all_values(const Values& tip, const nlohmann::json& piercing);

/// From each start the optimiser (NLopt's COBYLA, for it needs few values, bounds kept) goes over
/// the ranges with the piercing as its function, all side by side. Cost: the worst of the
/// objectives, each over that of the reference, and a penalty where limits are left; designs that
/// leave limits of the tip do not pierce. Up to plan.refinements trials of each start, in the order
/// in which they were made; after an interrupt what there is.
std::vector<Trial> refine(const Plan& plan, const std::vector<Design>& starts,
                          const Values& reference, const CaseStore& store, Session& session);

}  // namespace zona::studies::search
