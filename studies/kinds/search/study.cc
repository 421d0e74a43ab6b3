#include "studies/kinds/search/study.h"

#include <fmt/format.h>

#include <chrono>

#include "studies/kinds/piercing/case.h"
#include "studies/kinds/piercing/run.h"
#include "studies/kinds/search/run.h"
#include "studies/kinds/search/tip_stage.h"
#include "studies/parameters/fill_table.h"
#include "studies/run/run_directory.h"
#include "studies/simulation/cost_forecast.h"

namespace zona::studies {

namespace {

using namespace search;

PiercingCase reference_case(const Plan& plan) {
  return make_piercing_case(plan.base, fills_of(plan.base).front());
}

}  // namespace

Job prepare_search(const Configuration& study) {
  const Plan plan = plan_from(study);
  reference_case(plan);
  return [study](Session& session) { run_search(study, session); };
}

StudyCost estimate_search(const Configuration& study) {
  const Plan plan = plan_from(study);
  const SearchSize size = size_of(plan);
  const StudyCost one = piercing_cost(reference_case(plan));
  return {fmt::format("at most {:.0f} beams and {:.0f} piercings, each as the reference: {}",
                      size.beams, size.piercings, one.text),
          one.point_steps * size.piercings};
}

std::string try_search(const Configuration& study, int threads) {
  const Plan plan = plan_from(study);
  const SearchSize size = size_of(plan);
  TipMeter(plan, {});  // loads what computes beams
  const auto started = std::chrono::steady_clock::now();
  TipMeter(plan, {});
  const double beam =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  const auto forecast = [&] {
    const PiercingCase reference = reference_case(plan);
    OutputPlan output = output_plan(plan.base, reference.end);
    output.fields = false;
    CostForecast cost =
        forecast_cost(build_piercing(reference.setup), reference.step, reference.end, output, 1);
    cost.seconds = (cost.seconds * size.piercings + beam * size.beams) / threads;
    cost.memory += cost.own_memory * (threads - 1);
    cost.disk = 0;
    return cost;
  };
  return forecast_text(forecast, threads);
}

}  // namespace zona::studies
