#include "mpm/step/instruction_set.h"
#include "studies/run/version.h"
#include "studies/simulation/checkpoints.h"
#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona;
using namespace zona::studies::testing;
using Catch::Contains;

TEST_CASE("the log holds the levels that were asked for") {
  const ScratchDirectory scratch;
  const auto log_with = [&](const std::string& level, const std::string& more = "") {
    const auto out = scratch.path() / (level + std::to_string(more.size()));
    call("run " ZONA_SOURCE_DIR
         "/studies/verification/free_fall.toml --set output.fields=true"
         " --quiet --set 'run.log_level=\"" +
         level + "\"' --out " + out.string() + more);
    return read_text(out / "log.txt");
  };
  CHECK_THAT(log_with("info"), Contains("  info     zona ") && Contains(", scene study of ") &&
                                   Contains("complete after") && !Contains("frame 0"));
  CHECK_THAT(log_with("debug"), Contains("  debug    frame 0 at 0 us"));
  CHECK(log_with("warning").empty());
  CHECK_THAT(log_with("error", " --set 'body.0.velocity=[\"0\", \"0\", \"1e5 m/s\"]'"),
             Contains("  error    failed after") && Contains("left the grid") && !Contains("info"));
}

TEST_CASE("a checkpoint of another kind of processor is used with a warning") {
  const ScratchDirectory scratch;
  for (const std::string& processor : {std::string("none"), std::string(mpm::instruction_set())}) {
    mpm::write_checkpoint(
        (scratch.path() / "checkpoint-000000000007.h5").string(),
        {{"version", studies::zona_version()}, {"study", "s"}, {"processor", processor}},
        [](mpm::StateVisitor& visitor) {
          double value = 1;
          visitor.visit("value", value);
        });
    studies::CheckpointPlan plan;
    plan.study = "s";
    plan.resume = true;
    const studies::Checkpoints checkpoints(scratch.path(), plan);
    CHECK(checkpoints.is_resumed());
    CHECK((checkpoints.warning().find("the last bits") != std::string::npos) ==
          (processor == "none"));
  }
}
