#pragma once

#include "studies/input/configuration.h"
#include "studies/kinds/search/plan.h"
#include "studies/run/session.h"

namespace zona::studies::search {

/// Runs a search: beams, piercings of candidates, refinement, piercings with uncertain inputs,
/// derivatives. Writes the results, also when it is interrupted. Throws RunError when no design
/// keeps to the limits of the tip.
void run_search(const Configuration& search, Session& session);

/// Beams and piercings that a search takes at most.
struct SearchSize {
  double beams = 0;
  double piercings = 0;
};

SearchSize size_of(const Plan& plan);

}  // namespace zona::studies::search
