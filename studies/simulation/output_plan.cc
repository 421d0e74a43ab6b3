#include "studies/simulation/output_plan.h"

namespace zona::studies {

OutputPlan output_plan(const Configuration& study, double end) {
  const auto interval = [&](const char* key, double automatic) {
    return study.is_auto(key) ? automatic : study.quantity(key);
  };
  return {interval("output.history_interval", end / 500),
          interval("output.fields_interval", end / 20), study.boolean("output.fields")};
}

}  // namespace zona::studies
