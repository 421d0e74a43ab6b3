#include "studies/kinds/search/cost.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace zona::studies::search {

namespace {

constexpr double augmentation = 0.01;

}  // namespace

double worst_of(const std::vector<double>& objectives) {
  return *std::max_element(objectives.begin(), objectives.end()) +
         augmentation * std::accumulate(objectives.begin(), objectives.end(), 0.);
}

double excess(const std::vector<Limit>& limits, const Values& values) {
  double sum = 0;
  for (const Limit& limit : limits) {
    const auto found = values.find(limit.measure->name);
    if (found == values.end()) return std::numeric_limits<double>::infinity();
    sum += limit.excess(found->second);
  }
  return sum;
}

}  // namespace zona::studies::search
