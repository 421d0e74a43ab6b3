#pragma once

#include <string>

#include "studies/input/schema.h"

namespace zona::studies {

/// Complains of a step [s] that is longer than the run, which lasts until `end` [s], or makes more
/// than 1e8 steps of it.
void check_step(const std::string& step_key, double step, const std::string& end_key, double end,
                const Complain& complain);

}  // namespace zona::studies
