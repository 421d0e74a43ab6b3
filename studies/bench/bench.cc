#include "studies/bench/bench.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "mpm/step/instruction_set.h"
#include "studies/bench/integrators.h"
#include "studies/bench/scenes.h"
#include "studies/bench/step_model.h"
#include "studies/bench/stream.h"
#include "studies/input/input_error.h"
#include "studies/program/exit_code.h"
#include "studies/run/version.h"

namespace zona::studies::bench {

namespace {

using nlohmann::json;

/// Fraction of the critical step, as in studies.
constexpr double courant = 0.8;
/// Wall time of a window [s]; the least of many windows is what the machine can do.
constexpr double window = 0.1;
constexpr int warm_up_steps = 10;

double sum(const mpm::StageSeconds& seconds) {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

/// Time of a step with a number of threads.
struct Timing {
  int threads;
  mpm::StageSeconds stages;  ///< each in its best window [s]
  double best;               ///< a whole step in the best window [s]
  double median;             ///< in the median window [s]
  int windows;
};

struct SceneResult {
  std::string name;
  std::string description;
  long points;
  std::size_t nodes;
  StepModel model;
  std::vector<Timing> timings;
};

/// Mean seconds of a step in a window.
mpm::StageSeconds step_for_a_while(mpm::Solver& solver) {
  const mpm::StageSeconds before = solver.stage_seconds();
  mpm::StageSeconds spent{};
  int steps = 0;
  while (sum(spent) < window) {
    solver.step();
    ++steps;
    for (int s = 0; s < mpm::stage_count; ++s) spent[s] = solver.stage_seconds()[s] - before[s];
  }
  for (double& seconds : spent) seconds /= steps;
  return spent;
}

Timing time_steps(mpm::Solver& solver, double seconds) {
  for (int s = 0; s < warm_up_steps; ++s) solver.step();
  const double until = sum(solver.stage_seconds()) + seconds;
  std::vector<mpm::StageSeconds> windows;
  while (windows.empty() || sum(solver.stage_seconds()) < until)
    windows.push_back(step_for_a_while(solver));
  Timing timing{solver.threads(), windows.front(), 0, 0, static_cast<int>(windows.size())};
  std::vector<double> totals;
  for (const auto& w : windows) {
    for (int s = 0; s < mpm::stage_count; ++s) timing.stages[s] = std::min(timing.stages[s], w[s]);
    totals.push_back(sum(w));
  }
  std::sort(totals.begin(), totals.end());
  timing.best = totals.front();
  timing.median = totals[totals.size() / 2];
  return timing;
}

SceneResult measure(const Scene& scene, const std::vector<int>& threads, double seconds) {
  SceneResult result{scene.name, scene.description, 0, 0, {}, {}};
  for (int t : threads) {
    mpm::Model model = scene.make();
    const double step = scene.step > 0
                            ? scene.step
                            : courant * mpm::critical_step(model.grid, model.bodies).seconds;
    mpm::Solver solver(std::move(model), step, t);
    result.points = solver.point_count();
    result.nodes = solver.grid().node_count();
    result.model = step_model(solver);
    result.timings.push_back(time_steps(solver, seconds));
  }
  return result;
}

/// Time to move the modelled bytes over the time taken.
double bandwidth_share(double bytes, double seconds, double triad) {
  return bytes / triad / seconds;
}

void print(const SceneResult& r, const std::vector<double>& triad) {
  const auto points = static_cast<double>(r.points);
  fmt::print("\n{}: {}; {} points, {} nodes\n", r.name, r.description, r.points, r.nodes);
  for (std::size_t t = 0; t < r.timings.size(); ++t) {
    const Timing& timing = r.timings[t];
    fmt::print(
        "  {} thread{}: {:.1f} million point-steps/s at best, {:.1f} at the median of {} windows\n",
        timing.threads, timing.threads == 1 ? "" : "s", points / timing.best * 1e-6,
        points / timing.median * 1e-6, timing.windows);
    fmt::print("    {:<9}{:>11}{:>8}{:>10}{:>10}{:>10}{:>8}\n", "stage", "ns/point", "share",
               "B/point", "flop/pt", "GFlop/s", "bound");
    for (int s = 0; s <= mpm::stage_count; ++s) {
      const bool all = s == mpm::stage_count;
      const double seconds = all ? timing.best : timing.stages[s];
      const double bytes = all ? r.model.total_bytes() : r.model.bytes[s];
      const double flops = all ? r.model.total_flops() : r.model.flops[s];
      if (seconds < 1e-3 * timing.best) continue;
      fmt::print("    {:<9}{:>11.2f}{:>7.1f}%{:>10.0f}{:>10.0f}{:>10.1f}{:>7.1f}%\n",
                 all ? "step" : mpm::stage_names[s], seconds / points * 1e9,
                 100 * seconds / timing.best, bytes / points, flops / points,
                 flops / seconds * 1e-9, 100 * bandwidth_share(bytes, seconds, triad[t]));
    }
  }
  if (r.timings.size() > 1) {
    fmt::print("  parallel efficiency of {} threads: {:.2f}\n", r.timings.back().threads,
               r.timings.front().best / r.timings.back().best / r.timings.back().threads);
  }
}

json to_json(const SceneResult& r, const std::vector<double>& triad) {
  const auto points = static_cast<double>(r.points);
  json timings = json::array();
  for (std::size_t t = 0; t < r.timings.size(); ++t) {
    const Timing& timing = r.timings[t];
    json stages = json::object();
    for (int s = 0; s < mpm::stage_count; ++s) {
      stages[mpm::stage_names[s]] = {
          {"seconds", timing.stages[s]},
          {"bytes_per_point", r.model.bytes[s] / points},
          {"flops_per_point", r.model.flops[s] / points},
          {"bandwidth_share", timing.stages[s] > 0
                                  ? bandwidth_share(r.model.bytes[s], timing.stages[s], triad[t])
                                  : 0.0}};
    }
    timings.push_back(
        {{"threads", timing.threads},
         {"point_steps_per_second", points / timing.best},
         {"median_point_steps_per_second", points / timing.median},
         {"windows", timing.windows},
         {"seconds_per_step", timing.best},
         {"bandwidth_share", bandwidth_share(r.model.total_bytes(), timing.best, triad[t])},
         {"stages", stages}});
  }
  return {{"scene", r.name},
          {"points", r.points},
          {"nodes", r.nodes},
          {"bytes_per_point", r.model.total_bytes() / points},
          {"flops_per_point", r.model.total_flops() / points},
          {"timings", timings}};
}

std::vector<Scene> chosen_scenes(const std::vector<std::string>& names) {
  std::vector<Scene> chosen;
  for (const Scene& scene : scenes()) {
    if (names.empty() && scene.by_default) chosen.push_back(scene);
  }
  for (const std::string& name : names) {
    const auto found = std::find_if(scenes().begin(), scenes().end(),
                                    [&](const Scene& scene) { return scene.name == name; });
    if (found == scenes().end()) {
      throw InputError("bench", fmt::format("there is no scene '{}'; zona bench --list names them",
                                            printable(name)));
    }
    chosen.push_back(*found);
  }
  return chosen;
}

int list_scenes() {
  for (const Scene& scene : scenes()) {
    fmt::print("  {:<16}{}{}\n", scene.name, scene.description,
               scene.by_default ? "" : " (only by name)");
  }
  return exit_ok;
}

}  // namespace

int run_bench(const BenchOptions& options) {
  if (options.list) return list_scenes();
  if (options.beam) return print_integrators_of_the_beam();
  const std::vector<Scene> chosen = chosen_scenes(options.scenes);
  const int all = options.threads > 0 ? options.threads : omp_get_max_threads();
  const std::vector<int> threads = all > 1 ? std::vector<int>{1, all} : std::vector<int>{1};
  std::vector<double> triad;
  for (int t : threads) triad.push_back(stream_triad(t));
  json document{{"version", zona_version()},
                {"instruction_set", mpm::instruction_set()},
                {"courant", courant},
                {"stream_triad", json::array()},
                {"scenes", json::array()}};
  for (std::size_t t = 0; t < threads.size(); ++t)
    document["stream_triad"].push_back({{"threads", threads[t]}, {"bytes_per_second", triad[t]}});
  if (!options.json) {
    fmt::print("zona {}, {}; STREAM triad", zona_version(), mpm::instruction_set());
    for (std::size_t t = 0; t < threads.size(); ++t) {
      fmt::print("{} {:.1f} GB/s on {} thread{}", t ? "," : "", triad[t] * 1e-9, threads[t],
                 threads[t] == 1 ? "" : "s");
    }
    fmt::print(
        "\nns/point: best window of {} s. B/point, flop/pt: bytes that the stage has to move and "
        "its\n"
        "operations. bound: time of the triad for these bytes over the time taken. More in\n"
        "docs/performance.md.\n",
        window);
  }
  for (const Scene& scene : chosen) {
    if (!options.json) std::cerr << "zona: " << scene.name << "...\n";
    const SceneResult result = measure(scene, threads, options.seconds);
    if (options.json)
      document["scenes"].push_back(to_json(result, triad));
    else
      print(result, triad);
    std::fflush(stdout);
  }
  if (options.json) fmt::print("{}\n", document.dump(2));
  return exit_ok;
}

}  // namespace zona::studies::bench
