#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/fluid_flows.h"
#include "studies/verification/cases/case_list.h"
#include "studies/verification/evaluation/curves.h"

namespace zona::studies::verification {

namespace {

/// The time in a table that is nearest to a wanted one: profiles are written at whole steps.
double nearest_time(const ResultTable& table, double wanted) {
  const auto& times = table["time"];
  return *std::min_element(times.begin(), times.end(), [&](double a, double b) {
    return std::abs(a - wanted) < std::abs(b - wanted);
  });
}

// ---- flows over a wall that starts to move

constexpr references::SuddenWall wall{1e-3, 1000, 1e-6};

/// Water over a wall at y = 0 that moves with 1 um/s, in a channel of 1 mm.
struct WallFlow {
  std::string file;
  std::vector<double> times;  ///< of the profiles [s]
  std::function<double(double y, double time)> exact;
};

const WallFlow stokes_flow{"verification/stokes.toml", {0.005, 0.02}, [](double y, double time) {
                             return references::sudden_wall_velocity(wall, y, time);
                           }};

const WallFlow couette_flow{
    "verification/couette.toml", {0.02, 0.1, 0.5}, [](double y, double time) {
      return references::couette_velocity(wall, 1e-3, y, time);
    }};

std::vector<double> wall_cells(Extent extent) {
  return of_extent(extent, {0.1, 0.05}, {0.025});
}

std::vector<Run> wall_runs(const std::string& file, Extent extent) {
  std::vector<Run> runs;
  for (const double cell : wall_cells(extent)) {
    runs.push_back(
        {fmt::format("cell-{}", cell),
         file,
         {cell_override(cell), fmt::format("grid.high=[\"{0} mm\", \"1 mm\", \"{0} mm\"]", cell)}});
  }
  return runs;
}

/// Mean error of the profiles over the wall's speed.
double wall_error(const ResultTable& table, const WallFlow& flow) {
  double error = 0;
  for (const double wanted : flow.times) {
    const double time = nearest_time(table, wanted);
    const auto exact = [&](double y) { return flow.exact(y, time); };
    error += errors_of(curve_at(table, "position_y", "velocity_x", time, 0), exact).l1 /
             wall.speed / static_cast<double>(flow.times.size());
  }
  return error;
}

Panel wall_panel(const ResultTable& table, const WallFlow& flow) {
  Panel panel{"", {"velocity over that of the wall"}, {"height [mm]"}};
  for (const double wanted : flow.times) {
    const double time = nearest_time(table, wanted);
    Curve reference{panel.curves.empty() ? "exact" : "", {}, {}, Style::reference};
    for (int i = 0; i <= 200; ++i) {
      reference.add(flow.exact(i * 5e-6, time) / wall.speed, i * 5e-3);
    }
    const Curve computed = curve_at(table, "position_y", "velocity_x", time, 0);
    panel.curves.push_back(std::move(reference));
    panel.curves.push_back(
        {fmt::format("{:g} s", wanted), computed.y / wall.speed, computed.x * 1e3, Style::points});
  }
  return panel;
}

Evaluation evaluate_wall(const CaseResults& results, const WallFlow& flow, Extent extent) {
  Evaluation evaluation;
  const std::vector<double> cells = wall_cells(extent);
  const auto profiles = [&](double cell) {
    return results[fmt::format("cell-{}", cell)].table("profiles.csv");
  };
  std::vector<double> errors;
  for (const double cell : cells) errors.push_back(wall_error(profiles(cell), flow));
  evaluation.add({at_most("mean error of the profiles over the wall's speed", errors.back(), 0.01,
                          "second order: (1/20)^2 and what the first instants leave"),
                  converges("the profiles", cells * 1e-3, errors, 1.0,
                            "between the 2 of smooth flow and the 1 of a wall that the points of "
                            "the first cell average")});
  evaluation.draw("profiles", "Velocity over the height.",
                  {wall_panel(profiles(cells.back()), flow)});
  return evaluation;
}

Case wall_case(const std::string& name, const std::string& title, const std::string& reference,
               const WallFlow& flow) {
  const auto runs = [&](Extent extent) { return wall_runs(flow.file, extent); };
  const auto evaluate = [&](const CaseResults& results, Extent extent) {
    return evaluate_wall(results, flow, extent);
  };
  return {name, title, "", reference, runs, evaluate};
}

// ---- standing wave

std::vector<Run> wave_runs(Extent extent) {
  const std::string file = "verification/standing_wave.toml";
  const auto run = [&](const std::string& label, int cells, std::vector<std::string> overrides) {
    const double cell = 1000.0 / cells;
    overrides.push_back(cell_override(cell));
    overrides.push_back(fmt::format("grid.high=[\"1 m\", \"{} mm\", \"{} mm\"]", cell, cell));
    return Run{label, file, std::move(overrides)};
  };
  std::vector<Run> runs{run("linear-20", 20, {}),
                        run("linear-40", 40, {}),
                        run("averaged", 40, {"body.fluid.average_volume_strain=true"}),
                        run("quadratic-20", 20, {"grid.interpolation=\"quadratic\""}),
                        run("quadratic-40", 40, {"grid.interpolation=\"quadratic\""}),
                        run("viscous", 40, {"body.fluid.viscosity=\"20000 Pa s\""})};
  if (extent == Extent::full) {
    runs.push_back(run("linear-80", 80, {}));
    runs.push_back(run("quadratic-80", 80, {"grid.interpolation=\"quadratic\""}));
  }
  return runs;
}

/// Angular frequency from the first to the last time that the velocity in the middle crosses zero.
double frequency(const RunResults& run) {
  const ResultTable history = run.table("history.csv");
  const auto& t = history["time"];
  const auto& v = history["probe.middle.velocity_x"];
  std::vector<double> crossings;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if ((v[i - 1] > 0) == (v[i] > 0)) continue;
    crossings.push_back(t[i - 1] + (t[i] - t[i - 1]) * v[i - 1] / (v[i - 1] - v[i]));
  }
  return M_PI * static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
}

/// Rate at which the amplitude falls, from the largest speeds of the first and the last period.
double decay(const RunResults& run, double period) {
  const ResultTable history = run.table("history.csv");
  const auto& t = history["time"];
  const auto& v = history["probe.middle.velocity_x"];
  std::size_t first = 0, last = t.size() - 1;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] < period && std::abs(v[i]) > std::abs(v[first])) first = i;
    if (t[i] > t.back() - period && std::abs(v[i]) > std::abs(v[last])) last = i;
  }
  return std::log(std::abs(v[first]) / std::abs(v[last])) / (t[last] - t[first]);
}

Evaluation evaluate_wave(const CaseResults& results, Extent) {
  Evaluation evaluation;
  const references::StandingWave ideal{std::sqrt(5 * 6.13e8 / 1000), 1000, 0, 1, 1, 0.1};
  const double exact = ideal.angular_frequency();
  const double tolerance = 3 * std::pow(M_PI / 40, 2) / 8;
  for (const std::string functions : {"linear", "quadratic"}) {
    Curve errors;
    for (const int cells : {20, 40, 80}) {
      const std::string label = fmt::format("{}-{}", functions, cells);
      if (results.has(label))
        errors.add(1.0 / cells, std::abs(frequency(results[label]) / exact - 1));
    }
    evaluation.add(
        {converges("the frequency, " + functions, errors.x, errors.y, 1.7,
                   "lumped masses: (k h)^2/24 too low"),
         at_most("error of the frequency, " + functions + ", 40 cells", errors.y[1], tolerance,
                 "(k h)^2/24 of linear functions on lumped masses, three times that of B-splines, "
                 "which spread them")});
  }
  references::StandingWave viscous = ideal;
  viscous.viscosity = 20000;
  evaluation.add(
      {near("angular frequency with cell averages [rad/s]", frequency(results["averaged"]), exact,
            tolerance, "as above"),
       near("decay of a viscous wave [1/s]", decay(results["viscous"], 2 * M_PI / exact),
            viscous.decay_rate(), 0.05, "amplitudes read at 500 instants of some ten periods")});
  return evaluation;
}

// ---- free fall

std::vector<Run> fall_runs(Extent) {
  return {{"linear", "verification/free_fall.toml", {}},
          {"quadratic", "verification/free_fall.toml", {"grid.interpolation=\"quadratic\""}}};
}

Evaluation evaluate_fall(const CaseResults& results, Extent) {
  Evaluation evaluation;
  for (const std::string label : {"linear", "quadratic"}) {
    const RunResults& run = results[label];
    const double time = last(run, "time");
    const auto exact = references::free_fall(0, 0, 9.81, time);
    evaluation.add({near("speed after the fall [m/s], " + label, last(run, "probe.drop.velocity_z"),
                         exact.velocity, 1e-9, "rounding: gravity is uniform on the grid"),
                    near("depth of the fall [m], " + label, last(run, "probe.drop.displacement_z"),
                         exact.position, 1.1 * run.number("time_step") / time,
                         "the scheme moves with the new velocity: one step ahead, dt/t")});
  }
  return evaluation;
}

}  // namespace

std::vector<Case> flows() {
  return {wall_case("stokes", "Stokes' first problem", "error function", stokes_flow),
          wall_case("couette", "Start-up of Couette flow", "Fourier series", couette_flow),
          {"standing_wave", "Standing acoustic wave", "", "linear acoustics: frequency and decay",
           wave_runs, evaluate_wave},
          {"free_fall", "Free fall across cells", "", "uniform acceleration", fall_runs,
           evaluate_fall}};
}

}  // namespace zona::studies::verification
