#pragma once

#include <vector>

#include "studies/kinds/search/plan.h"

namespace zona::studies::search {

/// What an optimiser makes small of several objectives: the worst of them, and a hundredth of
/// their sum, so that what costs none of the worst is taken, too (augmented Chebyshev
/// scalarisation, Steuer and Choo 1983).
double worst_of(const std::vector<double>& objectives);

/// How far values leave limits, each by its own size, in all; infinite where one is unknown.
double excess(const std::vector<Limit>& limits, const Values& values);

}  // namespace zona::studies::search
