#include "studies/simulation/output_plan.h"

#include "studies/parameters/output_table.h"

namespace zona::studies {

OutputPlan output_plan(const Configuration& study, double end) {
  const auto output = study.read<Output>();
  return {output.history_interval.value_or(end / 500), output.fields_interval.value_or(end / 20),
          output.fields};
}

}  // namespace zona::studies
