#pragma once

#include <functional>
#include <nlopt.hpp>
#include <vector>

namespace zona::studies::search {

/// How a local optimiser searches the ranges, each taken as [0, 1].
struct Steps {
  double first, last;
  long evaluations;  ///< at most
};

/// Lets an optimiser look for the least cost from a place. The cost keeps what it sees, and ends
/// the search by throwing nlopt::forced_stop.
inline void minimise(nlopt::algorithm algorithm, std::vector<double> place, const Steps& steps,
                     std::function<double(const std::vector<double>&)> cost) {
  nlopt::opt optimiser(algorithm, static_cast<unsigned>(place.size()));
  const nlopt::vfunc call = [](const std::vector<double>& x, std::vector<double>&, void* data) {
    return (*static_cast<decltype(cost)*>(data))(x);
  };
  optimiser.set_min_objective(call, &cost);
  optimiser.set_lower_bounds(0);
  optimiser.set_upper_bounds(1);
  optimiser.set_initial_step(steps.first);
  optimiser.set_xtol_abs(steps.last);
  optimiser.set_maxeval(static_cast<int>(steps.evaluations));
  double least = 0;
  try {
    optimiser.optimize(place, least);
  } catch (const nlopt::forced_stop&) {
  } catch (const nlopt::roundoff_limited&) {  // as good as rounding allows
  }
}

}  // namespace zona::studies::search
