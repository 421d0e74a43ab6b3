#include "studies/parameters/step_limits.h"

#include <fmt/format.h>

namespace zona::studies {

void check_step(const std::string& step_key, double step, const std::string& end_key, double end,
                const Complain& complain) {
  constexpr double most = 1e8;
  if (step > end) {
    complain(step_key, fmt::format("the step of {:g} us is longer than the run of {:g} us; choose "
                                   "one below {}",
                                   step * 1e6, end * 1e6, end_key));
  } else if (end / step > most) {
    complain(step_key, fmt::format("the step of {:g} us makes {:g} steps of the run of {:g} us; at "
                                   "most 1e8 are allowed, so choose at least {:g} us",
                                   step * 1e6, end / step, end * 1e6, end * 1e6 / most));
  }
}

}  // namespace zona::studies
