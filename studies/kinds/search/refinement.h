#pragma once

#include <string>
#include <vector>

#include "studies/kinds/search/case_store.h"
#include "studies/kinds/search/tip_stage.h"

namespace zona::studies::search {

/// A design whose piercing the second optimiser has evaluated.
struct Evaluation {
  std::size_t start = 0;  ///< number of the design that the search started from
  Design design;
  Values values;  ///< of tip and oocyte; without the oocyte's where the piercing failed
  double cost = 0;
};

/// Measures of the tip and, where the piercing has results, of the oocyte.
Values all_values(const Values& tip, const nlohmann::json& piercing);

/// Local searches with the piercing as the function, one from each start, all side by side. The
/// optimiser is NLopt's COBYLA, which keeps bounds and needs few evaluations. Cost: the greatest of
/// the objectives, each over that of the reference, and a penalty for violated limits. Designs that
/// violate limits of the tip are not pierced. Returns up to plan.refinements evaluations of each
/// start, in the order in which they were made; after an interrupt those that are complete.
std::vector<Evaluation> refine(const Plan& plan, const std::vector<Design>& starts,
                               const Values& reference, const CaseStore& store, Session& session);

}  // namespace zona::studies::search
