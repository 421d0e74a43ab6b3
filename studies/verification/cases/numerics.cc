#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/profile_errors.h"
#include "studies/verification/cases/case_list.h"

// Each choice of the scheme against an exact solution, beside the source's.

namespace zona::studies::verification {

namespace {

using references::Sample;

// ---- vortex: averaged volumetric strain, quadratic functions, energy increment

struct VortexRun {
  std::string label;
  std::vector<std::string> overrides;
};

const std::vector<VortexRun> vortex_variants{
    {"source", {}},
    {"averaged", {"body.fluid.average_volume_strain=true"}},
    {"quadratic", {"grid.interpolation=\"quadratic\""}},
    {"mean-pressure", {"body.fluid.energy_increment=\"mean_pressure\""}},
    {"quadratic-mean-pressure",
     {"grid.interpolation=\"quadratic\"", "body.fluid.energy_increment=\"mean_pressure\""}}};

std::vector<int> vortex_cells(Extent extent) {
  return extent == Extent::quick ? std::vector<int>{8, 16} : std::vector<int>{8, 16, 32};
}

std::string vortex_label(const std::string& variant, int cells) {
  return fmt::format("{}-{}", variant, cells);
}

std::vector<Run> vortex_runs(Extent extent) {
  std::vector<Run> runs;
  for (const int cells : vortex_cells(extent)) {
    for (const auto& [variant, overrides] : vortex_variants) {
      runs.push_back({vortex_label(variant, cells), "verification/vortex.toml", overrides});
      const double h = 1.0 / cells;
      runs.back().overrides.push_back(fmt::format("grid.cell=\"{} m\"", h));
      runs.back().overrides.push_back(fmt::format("grid.high=[\"1 m\", \"1 m\", \"{} m\"]", h));
    }
  }
  return runs;
}

constexpr double vortex_viscosity = 0.01;  // kinematic [m^2/s]

/// v_y = -cos(kx) sin(ky) e^(-2 nu k^2 t), k = pi/m; the pressure falls with its square.
double vortex_decay(double time) {
  return std::exp(-2 * vortex_viscosity * M_PI * M_PI * time);
}

/// Velocity across the middle of the box over x at the end.
std::vector<Sample> vortex_velocity(const RunResults& run) {
  const ResultTable table = run.table("profiles.csv").where("profile", "middle");
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table["time"][i] < 0.45) continue;
    samples.push_back({table["position_x"][i], table["velocity_y"][i]});
  }
  return samples;
}

/// Mean error of that velocity over the 1 m/s that the vortex began with.
double vortex_error(const RunResults& run) {
  return references::profile_errors(
             vortex_velocity(run), [](double x) { return -std::cos(M_PI * x) * vortex_decay(0.5); })
      .l1;
}

/// Root mean square error of the pressure of thin slices, over all instants [Pa].
double vortex_pressure_error(const RunResults& run) {
  const ResultTable table = run.table("profiles.csv").where("profile", "points");
  double squares = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double decay = vortex_decay(table["time"][i]);
    const double exact =
        0.25 * decay * decay *
        (std::cos(2 * M_PI * table["position_x"][i]) + std::cos(2 * M_PI * table["position_y"][i]));
    squares += std::pow(table["pressure"][i] - exact, 2);
  }
  return std::sqrt(squares / static_cast<double>(table.rows()));
}

/// Change of kinetic and internal energy over the kinetic energy at the start.
double vortex_gain(const RunResults& run) {
  const ResultTable history = run.table("history.csv");
  const auto& kinetic = history["kinetic_energy"];
  const auto& stored = history["stored_energy"];
  return (kinetic.back() + stored.back() - kinetic[0] - stored[0]) / kinetic[0];
}

Evaluation evaluate_vortex(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const int finest = vortex_cells(extent).back();
  Panel velocities{
      fmt::format("{} cells, t = 0.5 s", finest), {"x [m]"}, {"velocity across [m/s]"}, {}};
  Panel pressures{"", {"cells"}, {"error of the pressure [Pa]", true}, {}};
  for (const std::string variant : {"source", "averaged", "quadratic"}) {
    Curve errors{variant, {}, {}, Style::line};
    for (const int cells : vortex_cells(extent)) {
      const RunResults& run = results[vortex_label(variant, cells)];
      errors.x.push_back(cells);
      errors.y.push_back(vortex_pressure_error(run));
      evaluation.checks.push_back(
          reported(fmt::format("mean error of the velocity [m/s], {}, {} cells", variant, cells),
                   vortex_error(run), "1 at the start", "across the middle of the box, t = 0.5 s"));
    }
    pressures.curves.push_back(std::move(errors));
    Curve curve{variant, {}, {}, Style::points};
    for (const auto& sample : vortex_velocity(results[vortex_label(variant, finest)])) {
      curve.x.push_back(sample.x);
      curve.y.push_back(sample.value);
    }
    velocities.curves.push_back(std::move(curve));
  }
  const auto ratio = [&](const std::string& variant, const auto& measure) {
    return measure(results[vortex_label(variant, 16)]) /
           measure(results[vortex_label("source", 16)]);
  };
  const std::string offered = "what an option is offered for, it has to halve at least";
  for (const std::string variant : {"averaged", "quadratic"}) {
    evaluation.checks.push_back(
        at_most("error of the pressure over the source's, 16 cells, " + variant,
                ratio(variant, vortex_pressure_error), 0.5, offered));
  }
  evaluation.checks.push_back(at_most("error of the velocity over the source's, 16 cells, averaged",
                                      ratio("averaged", vortex_error), 0.5, offered));
  for (const int cells : vortex_cells(extent)) {
    evaluation.checks.push_back(
        reported(fmt::format("energy gained over the motion's, source, {} cells", cells),
                 vortex_gain(results[vortex_label("source", cells)]),
                 fmt::format("{:.3g} with the mean pressure",
                             vortex_gain(results[vortex_label("mean-pressure", cells)])),
                 "the box is closed: 0 is exact. Noise of the pressure becomes heat"));
  }
  evaluation.checks.push_back(
      at_most("|energy gained| with quadratic functions and the mean pressure, 16 cells",
              std::abs(vortex_gain(results[vortex_label("quadratic-mean-pressure", 16)])), 0.01,
              "a percent of the motion's, an eighteenth of what viscosity takes until then"));
  Curve exact{"exact", {}, {}, Style::reference};
  for (int i = 0; i <= 100; ++i) {
    exact.x.push_back(i / 100.0);
    exact.y.push_back(-std::cos(M_PI * i / 100) * vortex_decay(0.5));
  }
  velocities.curves.push_back(std::move(exact));
  evaluation.figures.push_back({"vortex",
                                "The velocity across the middle, and the error of the pressure.",
                                {velocities, pressures},
                                {}});
  return evaluation;
}

// ---- drifting bar: quadratic functions

std::vector<int> drift_cells(Extent extent) {
  return extent == Extent::quick ? std::vector<int>{20, 40} : std::vector<int>{20, 40, 80};
}

std::vector<Run> drift_runs(Extent extent) {
  std::vector<Run> runs;
  for (const std::string functions : {"linear", "quadratic"}) {
    for (const int cells : drift_cells(extent)) {
      const double h = 1.0 / cells;
      runs.push_back({fmt::format("{}-{}", functions, cells),
                      "verification/drifting_bar.toml",
                      {fmt::format("grid.cell=\"{} m\"", h),
                       fmt::format("grid.high=[\"1.8 m\", \"{0} m\", \"{0} m\"]", h),
                       fmt::format("grid.interpolation=\"{}\"", functions)}});
    }
  }
  return runs;
}

constexpr double drift_speed = 0.25, swing_speed = 0.001;  // m/s

/// Axial stress over the place in the bar [Pa].
std::vector<Sample> drift_stress(const RunResults& run) {
  const ResultTable table = run.table("profiles.csv");
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    samples.push_back(
        {table["position_x"][i] - drift_speed * table["time"][i], table["stress_xx"][i]});
  }
  return samples;
}

/// The bar swings with v = V cos(pi X) cos(pi t), so sigma = -V sin(pi X) sin(pi t); all scales
/// are 1.
double drift_exact(double place) {
  return -swing_speed * std::sin(M_PI * place) * std::sin(M_PI * 1.75);
}

Evaluation evaluate_drift(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  Panel panel{"", {"place in the bar [m]"}, {"stress over its amplitude"}, {}};
  for (const std::string functions : {"linear", "quadratic"}) {
    std::vector<double> sizes, errors;
    for (const int cells : drift_cells(extent)) {
      const auto samples = drift_stress(results[fmt::format("{}-{}", functions, cells)]);
      sizes.push_back(1.0 / cells);
      errors.push_back(references::profile_errors(samples, drift_exact).l2 / swing_speed);
      evaluation.checks.push_back(reported(
          fmt::format("error of the stress over its amplitude, {}, {} cells", functions, cells),
          errors.back(), "none", "root mean square; the bar drifted by 0.44 m"));
      if (cells != drift_cells(extent).back()) continue;
      Curve curve{fmt::format("{}, {} cells", functions, cells), {}, {}, Style::line};
      for (const auto& sample : samples) {
        curve.x.push_back(sample.x);
        curve.y.push_back(sample.value / swing_speed);
      }
      panel.curves.push_back(std::move(curve));
    }
    if (functions == "quadratic") {
      evaluation.checks.push_back(converges("the stress, quadratic", sizes, errors, 1.7,
                                            "second order; its free ends cut cells"));
    } else {
      evaluation.checks.push_back(reported(
          "order of the stress, linear", references::observed_order(sizes, errors), "2 at rest",
          "the gradient jumps where a point crosses, by as much in small cells"));
    }
  }
  Curve exact{"exact", {}, {}, Style::reference};
  for (int i = 0; i <= 100; ++i) {
    exact.x.push_back(i / 100.0);
    exact.y.push_back(drift_exact(i / 100.0) / swing_speed);
  }
  panel.curves.push_back(std::move(exact));
  evaluation.figures.push_back({"stress", "Stress along the bar, t = 1.75 s.", {panel}, {}});
  return evaluation;
}

// ---- hanging bar: damping and PIC

std::vector<Run> hanging_runs(Extent) {
  const std::string file = "verification/hanging_bar.toml";
  return {{"free", file, {"numerics.damping=0"}},
          {"damped", file, {}},
          {"quadratic", file, {"grid.interpolation=\"quadratic\""}},
          {"pic", file, {"numerics.damping=0", "numerics.pic=0.01"}}};
}

Evaluation evaluate_hanging(const CaseResults& results, Extent) {
  Evaluation evaluation;
  const double weight = 1000 * 9.81, sag = weight / (2 * 1e8);  // of 1 m^3 on 1 m^2; of the end
  Panel motion{"", {"time [ms]"}, {"depth of the end over the static one"}, {}};
  Panel stresses{"at the end", {"place [m]"}, {"stress over weight"}, {}};
  for (const std::string label : {"free", "damped", "pic"}) {
    const ResultTable history = results[label].table("history.csv");
    Curve curve{label, {}, {}, Style::line};
    for (std::size_t i = 0; i < history.rows(); ++i) {
      curve.x.push_back(history["time"][i] * 1e3);
      curve.y.push_back(history["probe.end.displacement_x"][i] / sag);
    }
    motion.curves.push_back(std::move(curve));
  }
  const auto exact = [](double x) { return 1 - x; };
  for (const std::string label : {"damped", "quadratic", "pic"}) {
    const ResultTable table = results[label].table("profiles.csv");
    std::vector<Sample> samples;
    Curve curve{label, {}, {}, Style::points};
    for (std::size_t i = 0; i < table.rows(); ++i) {
      samples.push_back({table["position_x"][i], table["stress_xx"][i] / weight});
      curve.x.push_back(samples.back().x);
      curve.y.push_back(samples.back().value);
    }
    stresses.curves.push_back(std::move(curve));
    const double error = references::profile_errors(samples, exact).largest;
    const std::string quantity = "largest error of the static stress over the weight, " + label;
    if (label == "pic") {
      evaluation.checks.push_back(reported(
          quantity, error, "0",
          "PIC acts in every step, most on what changes from cell to cell; the slow swing of "
          "the whole bar it leaves for long"));
      continue;
    }
    evaluation.checks.push_back(at_most(
        quantity, error, label == "damped" ? 1e-3 : 5e-3,
        label == "damped" ? "strains of 1e-4 move points against the cells"
                          : "as linear functions, and three points a cell are no exact integral"));
  }
  Curve line{"exact", {0, 1}, {1, 0}, Style::reference};
  stresses.curves.push_back(std::move(line));
  evaluation.figures.push_back(
      {"rest", "The bar comes to rest; its stress then.", {motion, stresses}, {}});
  return evaluation;
}

}  // namespace

Case vortex() {
  return {
      "vortex",    "Decaying vortex: averaged strain, B-splines, work of the pressure",
      "",          "Taylor and Green's solution of the Navier-Stokes equations; a closed energy",
      vortex_runs, evaluate_vortex};
}

Case drifting_bar() {
  return {"drifting_bar",
          "Bar that drifts through cells: B-splines",
          "",
          "elastic standing wave",
          drift_runs,
          evaluate_drift};
}

Case hanging_bar() {
  return {
      "hanging_bar",   "Bar under its weight: damping and PIC", "", "static stress", hanging_runs,
      evaluate_hanging};
}

}  // namespace zona::studies::verification
