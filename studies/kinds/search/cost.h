#pragma once

#include <vector>

#include "studies/kinds/search/plan.h"

namespace zona::studies::search {

/// One cost for several objectives: the greatest plus a hundredth of their sum, so that objectives
/// below the greatest count a little, too (augmented Chebyshev scalarisation, Steuer and Choo
/// 1983).
double worst_of(const std::vector<double>& objectives);

/// Sum of the relative violations of all limits; infinite where a value is unknown.
double excess(const std::vector<Limit>& limits, const Values& values);

}  // namespace zona::studies::search
