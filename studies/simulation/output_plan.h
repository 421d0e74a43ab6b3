#pragma once

#include "studies/input/configuration.h"

namespace zona::studies {

/// When a simulation writes what [s].
struct OutputPlan {
  double history_interval = 1e-7;
  double fields_interval = 4e-6;
  bool fields = true;
};

/// As the [output] table says; "auto" intervals are 1/500 and 1/20 of `end` [s].
OutputPlan output_plan(const Configuration& study, double end);

}  // namespace zona::studies
