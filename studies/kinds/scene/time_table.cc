#include "studies/kinds/scene/time_table.h"

#include "studies/parameters/step_limits.h"
#include "studies/parameters/step_table.h"

namespace zona::studies {

namespace {

void check_given_step(const Configuration& study, const Complain& complain) {
  const auto step = study.value(&StepChoice::step);
  if (!step) return;
  check_step(study.key(&StepChoice::step), *step, study.key(&SceneTime::end),
             study.value(&SceneTime::end), complain);
}

}  // namespace

void declare_scene_time(Schema& schema) {
  TableKeys<SceneTime> keys(schema, "time", "Time integration.");
  keys.quantity("end", &SceneTime::end, "s", "")
      .without_default()
      .in("(0, 1e6]")
      .doc("End of the simulation.");
  declare_step(schema, "(0, 1e6]", "");
  schema.check(check_given_step);
}

}  // namespace zona::studies
