#pragma once

#include <vector>

#include "studies/kinds/search/tip_meter.h"
#include "studies/run/session.h"

namespace zona::studies::search {

/// A design and the measures of its tip.
struct Design {
  std::size_t combination = 0;  ///< of listed values
  std::vector<double> place;    ///< in the unit cube of the ranges
  Overrides overrides;
  Values tip;
};

/// Results of the beams.
struct TipStage {
  Values reference;
  std::vector<Design> designs;  ///< all possible ones that were tried, by combination
  std::size_t impossible = 0;   ///< designs whose overrides contradict each other
};

/// Samples every combination of listed values by a hypercube, then minimises in it, combinations in
/// parallel. Results do not depend on the number of threads; after an interrupt they hold what was
/// computed until then.
TipStage explore(const Plan& plan, Session& session);

/// Numbers of the designs that pierce: equally many of each combination, spread over the Pareto
/// front of the tip's objectives, among the designs within the limits of the tip.
std::vector<std::size_t> choose_candidates(const Plan& plan, const TipStage& stage);

}  // namespace zona::studies::search
