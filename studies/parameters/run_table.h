#pragma once

#include <spdlog/common.h>

#include "studies/input/table_keys.h"

namespace zona::studies {

/// Settings of the program.
struct Run {
  int threads;  ///< 0: all
  spdlog::level::level_enum log_level;
};

/// Intervals of checkpoints.
struct CheckpointIntervals {
  double checkpoint_interval;  ///< wall time [s]; 0: none by time
  long checkpoint_steps;       ///< 0: none by steps
};

/// Keys of [run], which must be open, of any study.
void declare_threads_and_log(Schema& schema);
/// The section [run] of studies that take many steps.
void declare_run(Schema& schema);

}  // namespace zona::studies
