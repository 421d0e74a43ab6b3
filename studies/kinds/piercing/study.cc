#include "studies/kinds/piercing/study.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "studies/kinds/piercing/run.h"
#include "studies/kinds/piercing/scheme_tables.h"
#include "studies/parameters/fill_table.h"
#include "studies/run/run_directory.h"
#include "studies/run/session.h"
#include "studies/simulation/cost_forecast.h"

namespace zona::studies {

namespace {

std::string conclusion(const nlohmann::json& results, int threads) {
  const auto& first = results["time_of_first_failure"];
  return fmt::format(
      "{} of the zona's points failed, {:.4g} um^2{}; largest strain away from the hole {:.4f}\n"
      "{:.1f} million point-steps/s on {} threads\n",
      results["failed_points"].get<int>(), results["failed_area"].get<double>() * 1e12,
      first.is_null() ? "" : fmt::format(", the first after {:.2f} us", first.get<double>() * 1e6),
      results["largest_strain_away"].get<double>(),
      results["point_steps_per_second"].get<double>() / 1e6, threads);
}

}  // namespace

Job prepare_piercing(const Configuration& study) {
  const auto piercing =
      std::make_shared<PiercingCase>(make_piercing_case(study, fills_of(study).front()));
  return [study, piercing](Session& session) {
    session.directory.log().info(piercing_cost(*piercing).text);
    session.progress.start("piercing", piercing->end);
    run_piercing(
        *piercing,
        {study, output_plan(study, simulation_end(study)), checkpoint_plan(study, session.resume),
         session.directory.path(), session.threads, session.directory.log(), session.progress},
        session.results);
    session.progress.finish();
    session.conclusion = conclusion(session.results, session.threads);
  };
}

StudyCost estimate_piercing(const Configuration& study) {
  return piercing_cost(make_piercing_case(study, fills_of(study).front()));
}

std::string try_piercing(const Configuration& study, int threads) {
  const PiercingCase piercing = make_piercing_case(study, fills_of(study).front());
  const auto forecast = [&] {
    return forecast_cost(build_piercing(piercing.setup), piercing.step, piercing.end,
                         output_plan(study, piercing.end), threads);
  };
  return forecast_text(forecast, threads);
}

}  // namespace zona::studies
