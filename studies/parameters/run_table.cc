#include "studies/parameters/run_table.h"

namespace zona::studies {

namespace {

const Words<spdlog::level::level_enum> kLogLevels{{"info", spdlog::level::info},
                                                  {"debug", spdlog::level::debug},
                                                  {"warning", spdlog::level::warn},
                                                  {"error", spdlog::level::err}};

}  // namespace

void declare_threads_and_log(Schema& schema) {
  TableKeys<Run> keys(schema, "run");
  keys.integer("threads", &Run::threads, 0).in("[0, 4096]").doc("Number of threads; 0 takes all.");
  keys.choice("log_level", &Run::log_level, kLogLevels)
      .doc(
          "Detail of log.txt: \"debug\" adds every frame; \"warning\" and \"error\" keep only "
          "those.");
}

void declare_run(Schema& schema) {
  schema.section("run", "Settings of the program, which do not change the results.");
  declare_threads_and_log(schema);
  TableKeys<CheckpointIntervals> keys(schema, "run");
  keys.quantity("checkpoint_interval", &CheckpointIntervals::checkpoint_interval, "s", "300 s")
      .in("[0, 1e7]")
      .doc(
          "Wall time between two checkpoints, from which --resume continues; 0 leaves them to "
          "checkpoint_steps. The latest two are kept until the run is complete.");
  keys.integer("checkpoint_steps", &CheckpointIntervals::checkpoint_steps, 0)
      .in("[0, 1000000000]")
      .doc("Steps between two checkpoints, besides those by time; 0 makes none.");
}

}  // namespace zona::studies
