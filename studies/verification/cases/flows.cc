#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/fluid_flows.h"
#include "studies/references/profile_errors.h"
#include "studies/verification/cases/case_list.h"

namespace zona::studies::verification {

namespace {

std::string cell_override(double millimetres) {
  return fmt::format("grid.cell=\"{} mm\"", millimetres);
}

/// The time in a table that is nearest to a wanted one: profiles are written at whole steps.
double nearest_time(const ResultTable& table, double wanted) {
  double nearest = table["time"].front();
  for (const double time : table["time"]) {
    if (std::abs(time - wanted) < std::abs(nearest - wanted)) nearest = time;
  }
  return nearest;
}

/// x velocity over height at one time of profiles.csv, as a curve.
Curve velocity_profile(const ResultTable& table, double time, const std::string& label) {
  Curve curve{label, {}, {}, Style::points};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table["time"][i] != time) continue;
    curve.x.push_back(table["velocity_x"][i]);
    curve.y.push_back(table["position_y"][i]);
  }
  return curve;
}

/// Mean error of a profile over the wall's speed.
double profile_error(const Curve& curve, double speed, const std::function<double(double)>& exact) {
  std::vector<references::Sample> samples;
  for (std::size_t i = 0; i < curve.x.size(); ++i) samples.push_back({curve.y[i], curve.x[i]});
  return references::profile_errors(samples, exact).l1 / speed;
}

// ---- flows over a wall that starts to move

/// Water over a wall at y = 0 that moves with 1 um/s, in a channel of 1 mm.
struct WallFlow {
  std::string file;
  std::vector<double> times;  ///< of the profiles [s]
  std::function<double(double y, double time)> exact;
};

constexpr references::SuddenWall wall{1e-3, 1000, 1e-6};

std::vector<Run> wall_runs(const std::string& file, Extent extent) {
  std::vector<Run> runs{
      {"cell-0.1", file, {cell_override(0.1), "grid.high=[\"0.1 mm\", \"1 mm\", \"0.1 mm\"]"}},
      {"cell-0.05", file, {cell_override(0.05), "grid.high=[\"0.05 mm\", \"1 mm\", \"0.05 mm\"]"}}};
  if (extent == Extent::full) {
    runs.push_back({"cell-0.025",
                    file,
                    {cell_override(0.025), "grid.high=[\"0.025 mm\", \"1 mm\", \"0.025 mm\"]"}});
  }
  return runs;
}

Evaluation evaluate_wall(const CaseResults& results, const WallFlow& flow, Extent extent) {
  Evaluation evaluation;
  std::vector<double> cells{0.1, 0.05};
  if (extent == Extent::full) cells.push_back(0.025);
  std::vector<double> errors;
  Panel panel{"", {"velocity over that of the wall"}, {"height [mm]"}, {}};
  for (const double cell : cells) {
    const ResultTable table = results[fmt::format("cell-{}", cell)].table("profiles.csv");
    double error = 0;
    for (const double wanted : flow.times) {
      const double time = nearest_time(table, wanted);
      const auto exact = [&](double y) { return flow.exact(y, time); };
      Curve computed = velocity_profile(table, time, "");
      error += profile_error(computed, wall.speed, exact) / static_cast<double>(flow.times.size());
      if (cell != cells.back()) continue;
      Curve reference{wanted == flow.times.front() ? "exact" : "", {}, {}, Style::reference};
      for (int i = 0; i <= 200; ++i) {
        reference.x.push_back(exact(i * 5e-6) / wall.speed);
        reference.y.push_back(i * 5e-3);
      }
      for (double& v : computed.x) v /= wall.speed;
      for (double& y : computed.y) y *= 1e3;
      computed.label = fmt::format("{:g} s", wanted);
      panel.curves.push_back(std::move(reference));
      panel.curves.push_back(std::move(computed));
    }
    errors.push_back(error);
  }
  for (double& cell : cells) cell *= 1e-3;
  evaluation.checks.push_back(at_most("mean error of the profiles over the wall's speed",
                                      errors.back(), 0.01,
                                      "second order: (1/20)^2 and what the "
                                      "first instants leave"));
  evaluation.checks.push_back(converges("the profiles", cells, errors, 1.0,
                                        "between the 2 of smooth flow and the 1 of a wall that the "
                                        "points of the first cell average"));
  evaluation.figures.push_back({"profiles", "Velocity over the height.", {panel}, {}});
  return evaluation;
}

WallFlow stokes_flow() {
  return {"verification/stokes.toml", {0.005, 0.02}, [](double y, double time) {
            return references::sudden_wall_velocity(wall, y, time);
          }};
}

WallFlow couette_flow() {
  return {"verification/couette.toml", {0.02, 0.1, 0.5}, [](double y, double time) {
            return references::couette_velocity(wall, 1e-3, y, time);
          }};
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

/// Instants at which the velocity in the middle crosses zero.
std::vector<double> zero_crossings(const ResultTable& history) {
  const auto& t = history["time"];
  const auto& v = history["probe.middle.velocity_x"];
  std::vector<double> crossings;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if ((v[i - 1] > 0) != (v[i] > 0)) {
      crossings.push_back(t[i - 1] + (t[i] - t[i - 1]) * v[i - 1] / (v[i - 1] - v[i]));
    }
  }
  return crossings;
}

/// Angular frequency from the first to the last crossing.
double frequency(const RunResults& run) {
  const auto crossings = zero_crossings(run.table("history.csv"));
  return M_PI * static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
}

/// Rate at which the amplitude falls, from the largest speeds of the first and the last period.
double decay(const RunResults& run, double period) {
  const ResultTable history = run.table("history.csv");
  const auto& t = history["time"];
  const auto& v = history["probe.middle.velocity_x"];
  double first = 0, last = 0, at_first = 0, at_last = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] < period && std::abs(v[i]) > first) {
      first = std::abs(v[i]);
      at_first = t[i];
    }
    if (t[i] > t.back() - period && std::abs(v[i]) > last) {
      last = std::abs(v[i]);
      at_last = t[i];
    }
  }
  return std::log(first / last) / (at_last - at_first);
}

Evaluation evaluate_wave(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const double c = std::sqrt(5 * 6.13e8 / 1000);
  const references::StandingWave ideal{c, 1000, 0, 1, 1, 0.1};
  const double exact = ideal.angular_frequency();
  for (const std::string functions : {"linear", "quadratic"}) {
    std::vector<double> sizes, errors;
    for (const int cells : {20, 40, 80}) {
      const std::string label = fmt::format("{}-{}", functions, cells);
      if (!results.has(label)) continue;
      sizes.push_back(1.0 / cells);
      errors.push_back(std::abs(frequency(results[label]) / exact - 1));
    }
    evaluation.checks.push_back(converges("the frequency, " + functions, sizes, errors, 1.7,
                                          "lumped masses: (k h)^2/24 too low"));
    evaluation.checks.push_back(at_most("error of the frequency, " + functions + ", 40 cells",
                                        errors[1], 3 * std::pow(M_PI / 40, 2) / 8,
                                        "(k h)^2/24 of linear functions on lumped masses, three "
                                        "times that of B-splines, which spread them"));
  }
  evaluation.checks.push_back(near("angular frequency with cell averages [rad/s]",
                                   frequency(results["averaged"]), exact,
                                   3 * std::pow(M_PI / 40, 2) / 8, "as above"));
  references::StandingWave viscous = ideal;
  viscous.viscosity = 20000;
  evaluation.checks.push_back(
      near("decay of a viscous wave [1/s]", decay(results["viscous"], 2 * M_PI / exact),
           viscous.decay_rate(), 0.05, "amplitudes read at 500 instants of some ten periods"));
  (void)extent;
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
    const ResultTable history = results[label].table("history.csv");
    const double time = history["time"].back();
    const double step = results[label].number("time_step");
    const auto exact = references::free_fall(0, 0, 9.81, time);
    evaluation.checks.push_back(near("speed after the fall [m/s], " + label,
                                     history["probe.drop.velocity_z"].back(), exact.velocity, 1e-9,
                                     "rounding: gravity is uniform on the grid"));
    evaluation.checks.push_back(near("depth of the fall [m], " + label,
                                     history["probe.drop.displacement_z"].back(), exact.position,
                                     1.1 * step / time,
                                     "the scheme moves with the new velocity: one step "
                                     "ahead, dt/t"));
  }
  return evaluation;
}

}  // namespace

Case stokes() {
  return {"stokes",
          "Stokes' first problem",
          "",
          "error function",
          [](Extent extent) { return wall_runs(stokes_flow().file, extent); },
          [](const CaseResults& results, Extent extent) {
            return evaluate_wall(results, stokes_flow(), extent);
          }};
}

Case couette() {
  return {"couette",
          "Start-up of Couette flow",
          "",
          "Fourier series",
          [](Extent extent) { return wall_runs(couette_flow().file, extent); },
          [](const CaseResults& results, Extent extent) {
            return evaluate_wall(results, couette_flow(), extent);
          }};
}

Case standing_wave() {
  return {"standing_wave",
          "Standing acoustic wave",
          "",
          "linear acoustics: frequency and decay",
          wave_runs,
          evaluate_wave};
}

Case free_fall() {
  return {"free_fall",  "Free fall across cells", "", "uniform acceleration", fall_runs,
          evaluate_fall};
}

}  // namespace zona::studies::verification
