#include <fmt/format.h>

#include <cmath>

#include "studies/verification/cases/case_list.h"
#include "studies/verification/evaluation/curves.h"

// Each choice of the scheme against an exact solution, beside the source's.

namespace zona::studies::verification {

namespace {

// ---- vortex: averaged volumetric strain, quadratic functions, energy increment

const std::vector<std::pair<std::string, std::vector<std::string>>> vortex_variants{
    {"source", {}},
    {"averaged", {"body.fluid.average_volume_strain=true"}},
    {"quadratic", {"grid.interpolation=\"quadratic\""}},
    {"mean-pressure", {"body.fluid.energy_increment=\"mean_pressure\""}},
    {"quadratic-mean-pressure",
     {"grid.interpolation=\"quadratic\"", "body.fluid.energy_increment=\"mean_pressure\""}}};

std::vector<int> vortex_cells(Extent extent) {
  return of_extent(extent, {8, 16}, {32});
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
Curve vortex_velocity(const RunResults& run) {
  return curve_at(run.table("profiles.csv").where("profile", "middle"), "position_x", "velocity_y",
                  0.5, 0.05);
}

/// Mean error of that velocity over the 1 m/s that the vortex began with.
double vortex_error(const RunResults& run) {
  return errors_of(vortex_velocity(run),
                   [](double x) { return -std::cos(M_PI * x) * vortex_decay(0.5); })
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

/// What the options change, in cells of a sixteenth.
std::vector<Check> vortex_options(const CaseResults& results, Extent extent) {
  const auto ratio = [&](const std::string& variant, const auto& measure) {
    return measure(results[vortex_label(variant, 16)]) /
           measure(results[vortex_label("source", 16)]);
  };
  const std::string offered = "what an option is offered for, it has to halve at least";
  const std::string pressure = "error of the pressure over the source's, 16 cells, ";
  std::vector<Check> checks{
      at_most(pressure + "averaged", ratio("averaged", vortex_pressure_error), 0.5, offered),
      at_most(pressure + "quadratic", ratio("quadratic", vortex_pressure_error), 0.5, offered),
      at_most("error of the velocity over the source's, 16 cells, averaged",
              ratio("averaged", vortex_error), 0.5, offered)};
  for (const int cells : vortex_cells(extent)) {
    checks.push_back(
        reported(fmt::format("energy gained over the motion's, source, {} cells", cells),
                 vortex_gain(results[vortex_label("source", cells)]),
                 fmt::format("{:.3g} with the mean pressure",
                             vortex_gain(results[vortex_label("mean-pressure", cells)])),
                 "the box is closed: 0 is exact. Noise of the pressure becomes heat"));
  }
  checks.push_back(
      at_most("|energy gained| with quadratic functions and the mean pressure, 16 cells",
              std::abs(vortex_gain(results[vortex_label("quadratic-mean-pressure", 16)])), 0.01,
              "a percent of the motion's, an eighteenth of what viscosity takes until then"));
  return checks;
}

Evaluation evaluate_vortex(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const int finest = vortex_cells(extent).back();
  Panel velocities{
      fmt::format("{} cells, t = 0.5 s", finest), {"x [m]"}, {"velocity across [m/s]"}};
  Panel pressures{"", {"cells"}, {"error of the pressure [Pa]", true}};
  for (const std::string variant : {"source", "averaged", "quadratic"}) {
    Curve errors{variant};
    for (const int cells : vortex_cells(extent)) {
      const RunResults& run = results[vortex_label(variant, cells)];
      errors.add(cells, vortex_pressure_error(run));
      evaluation.add(
          reported(fmt::format("mean error of the velocity [m/s], {}, {} cells", variant, cells),
                   vortex_error(run), "1 at the start", "across the middle of the box, t = 0.5 s"));
    }
    pressures.curves.push_back(std::move(errors));
    const Curve velocity = vortex_velocity(results[vortex_label(variant, finest)]);
    velocities.curves.push_back({variant, velocity.x, velocity.y, Style::points});
  }
  evaluation.add(vortex_options(results, extent));
  Curve exact{"exact", {}, {}, Style::reference};
  for (int i = 0; i <= 100; ++i) {
    exact.add(i / 100.0, -std::cos(M_PI * i / 100) * vortex_decay(0.5));
  }
  velocities.curves.push_back(std::move(exact));
  evaluation.draw("vortex", "The velocity across the middle, and the error of the pressure.",
                  {velocities, pressures});
  return evaluation;
}

// ---- drifting bar: quadratic functions

std::vector<int> drift_cells(Extent extent) {
  return of_extent(extent, {20, 40}, {80});
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
Curve drift_stress(const RunResults& run) {
  const ResultTable table = run.table("profiles.csv");
  Curve curve;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    curve.add(table["position_x"][i] - drift_speed * table["time"][i], table["stress_xx"][i]);
  }
  return curve;
}

/// The bar swings with v = V cos(pi X) cos(pi t), so sigma = -V sin(pi X) sin(pi t); all scales
/// are 1.
double drift_exact(double place) {
  return -swing_speed * std::sin(M_PI * place) * std::sin(M_PI * 1.75);
}

Evaluation evaluate_drift(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  Panel panel{"", {"place in the bar [m]"}, {"stress over its amplitude"}};
  for (const std::string functions : {"linear", "quadratic"}) {
    Curve errors, stress;
    for (const int cells : drift_cells(extent)) {
      stress = drift_stress(results[fmt::format("{}-{}", functions, cells)]);
      stress.label = fmt::format("{}, {} cells", functions, cells);
      errors.add(1.0 / cells, errors_of(stress, drift_exact).l2 / swing_speed);
      evaluation.add(reported("error of the stress over its amplitude, " + stress.label,
                              errors.y.back(), "none",
                              "root mean square; the bar drifted by 0.44 m"));
    }
    panel.curves.push_back({stress.label, stress.x, stress.y / swing_speed});
    if (functions == "quadratic") {
      evaluation.add(converges("the stress, quadratic", errors.x, errors.y, 1.7,
                               "second order; its free ends cut cells"));
    } else {
      evaluation.add(reported(
          "order of the stress, linear", references::observed_order(errors.x, errors.y),
          "2 at rest", "the gradient jumps where a point crosses, by as much in small cells"));
    }
  }
  panel.curves.push_back(
      exact_curve(1, 100, [](double place) { return drift_exact(place) / swing_speed; }));
  evaluation.draw("stress", "Stress along the bar, t = 1.75 s.", {panel});
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

constexpr double bar_weight = 1000 * 9.81;          // of 1 m^3 on 1 m^2 [Pa]
constexpr double bar_sag = bar_weight / (2 * 1e8);  // of the end [m]

Check static_stress(const std::string& label, double error) {
  const std::string quantity = "largest error of the static stress over the weight, " + label;
  if (label == "damped")
    return at_most(quantity, error, 1e-3, "strains of 1e-4 move points against the cells");
  if (label == "quadratic")
    return at_most(quantity, error, 5e-3,
                   "as linear functions, and three points a cell are no exact integral");
  return reported(quantity, error, "0",
                  "PIC acts in every step, most on what changes from cell to cell; the slow swing "
                  "of the whole bar it leaves for long");
}

Evaluation evaluate_hanging(const CaseResults& results, Extent) {
  Evaluation evaluation;
  Panel motion{"", {"time [ms]"}, {"depth of the end over the static one"}};
  Panel stresses{"at the end", {"place [m]"}, {"stress over weight"}};
  for (const std::string label : {"free", "damped", "pic"}) {
    const ResultTable history = results[label].table("history.csv");
    motion.curves.push_back(
        {label, history["time"] * 1e3, history["probe.end.displacement_x"] / bar_sag});
  }
  for (const std::string label : {"damped", "quadratic", "pic"}) {
    const ResultTable table = results[label].table("profiles.csv");
    stresses.curves.push_back(
        {label, table["position_x"], table["stress_xx"] / bar_weight, Style::points});
    const auto exact = [](double x) { return 1 - x; };
    evaluation.add(static_stress(label, errors_of(stresses.curves.back(), exact).largest));
  }
  stresses.curves.push_back({"exact", {0, 1}, {1, 0}, Style::reference});
  evaluation.draw("rest", "The bar comes to rest; its stress then.", {motion, stresses});
  return evaluation;
}

}  // namespace

std::vector<Case> numerics() {
  return {{"vortex", "Decaying vortex: averaged strain, B-splines, work of the pressure", "",
           "Taylor and Green's solution of the Navier-Stokes equations; a closed energy",
           vortex_runs, evaluate_vortex},
          {"drifting_bar", "Bar that drifts through cells: B-splines", "", "elastic standing wave",
           drift_runs, evaluate_drift},
          {"hanging_bar", "Bar under its weight: damping and PIC", "", "static stress",
           hanging_runs, evaluate_hanging}};
}

}  // namespace zona::studies::verification
