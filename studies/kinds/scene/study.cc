#include "studies/kinds/scene/study.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "studies/kinds/scene/case.h"
#include "studies/kinds/scene/run.h"
#include "studies/run/run_directory.h"
#include "studies/simulation/cost_forecast.h"
#include "studies/simulation/output_plan.h"

namespace zona::studies {

namespace {

/// A line for each column of a probe: its last, lowest and highest value.
std::string probe_table(const nlohmann::json& results) {
  if (!results.contains("probes")) return "";
  std::string text =
      fmt::format("{:<36}{:>14}{:>14}{:>14}\n", "probe [SI]", "final", "lowest", "highest");
  for (const auto& [name, probe] : results["probes"].items()) {
    for (const auto& [column, values] : probe.items()) {
      if (!values.is_object()) continue;
      text += fmt::format("{:<36}{:>14.6g}{:>14.6g}{:>14.6g}\n", name + "." + column,
                          values["final"].get<double>(), values["lowest"].get<double>(),
                          values["highest"].get<double>());
    }
  }
  return text;
}

}  // namespace

Job prepare_scene(const Configuration& study) {
  const auto scene = std::make_shared<SceneCase>(make_scene_case(study));
  return [scene](Session& session) {
    session.directory.log().info(scene_cost(*scene).text);
    run_scene(*scene, session);
    const auto& r = session.results;
    session.conclusion =
        fmt::format("{}{} points, {} steps, {:.1f} million point-steps/s on {} threads\n",
                    probe_table(r), r["points"].get<long>(), r["steps"].get<long>(),
                    r["point_steps_per_second"].get<double>() / 1e6, session.threads);
  };
}

StudyCost estimate_scene(const Configuration& study) {
  return scene_cost(make_scene_case(study));
}

std::string try_scene(const Configuration& study, int threads) {
  SceneCase scene = make_scene_case(study);
  const auto forecast = [&] {
    return forecast_cost(std::move(scene.model), scene.step.seconds, scene.end,
                         output_plan(study, scene.end), threads);
  };
  return forecast_text(forecast, threads);
}

}  // namespace zona::studies
