#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/body_impact.h"
#include "studies/references/elastoplastic_bar.h"
#include "studies/verification/cases/case_list.h"
#include "studies/verification/evaluation/curves.h"

namespace zona::studies::verification {

namespace {

// ---- impact of aluminium on steel

struct ImpactRun {
  double cell;  ///< [mm]
  int across;   ///< points per cell along x and y

  std::string label() const { return fmt::format("cell-{:g}mm-points-{}", cell, across * across); }
};

std::vector<ImpactRun> impact_resolutions(Extent extent) {
  return of_extent<ImpactRun>(extent, {{10, 1}, {5, 1}, {10, 2}, {10, 3}}, {{2, 1}});
}

std::vector<Run> impact_runs(Extent extent) {
  std::vector<Run> runs;
  for (const ImpactRun& run : impact_resolutions(extent)) {
    const std::string points = fmt::format("[{}, {}, 1]", run.across, run.across);
    runs.push_back(
        {run.label(),
         "verification/impact.toml",
         {cell_override(run.cell), "grid.low=[\"-0.15 m\", \"-0.1 m\", \"0 m\"]",
          fmt::format("grid.high=[\"0.15 m\", \"0.4 m\", \"{} mm\"]", run.cell),
          "body.aluminium.points_per_cell=" + points, "body.steel.points_per_cell=" + points}});
  }
  return runs;
}

/// Normal stress at point A of the steel: exact until releases arrive.
struct ImpactStress {
  references::BodyImpact impact = references::impact_of_the_source();
  references::ImpactSide side = references::ImpactSide::target;
  double distance = references::ImpactProbe{}.distance;
  double plateau = references::impact_plateau(impact, side).stress;
  references::ImpactWindow window =
      references::impact_window(impact, side, distance, impact.height / 2);

  /// Mean of |stress - exact| over the window, over the plateau.
  double error(const RunResults& run) const {
    const ResultTable history = run.table("history.csv");
    Curve curve;
    for (std::size_t i = 0; i < history.rows() && history["time"][i] < window.end(); ++i) {
      curve.add(history["time"][i], history["probe.A.stress_xx"][i]);
    }
    const auto exact = [&](double time) {
      return references::impact_state(impact, side, distance, time).stress;
    };
    return errors_of(curve, exact).l1 / std::abs(plateau);
  }

  Curve curve() const {
    return {"exact until releases arrive",
            {0, window.arrival * 1e6, window.arrival * 1e6, window.end() * 1e6},
            {0, 0, plateau / 1e6, plateau / 1e6},
            Style::reference};
  }
};

Evaluation evaluate_impact(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const ImpactStress exact;
  Panel mesh{"one point per cell", {"time [us]"}, {"stress at A [MPa]"}};
  Panel points{"cells of 10 mm", {"time [us]"}, {"stress at A [MPa]"}};
  Curve cell_errors, point_errors;  // over the cells and the points' spacing [mm]
  for (const ImpactRun& run : impact_resolutions(extent)) {
    const RunResults& result = results[run.label()];
    const ResultTable history = result.table("history.csv");
    const double error = exact.error(result);
    evaluation.add(reported(
        "mean error until the first release over the plateau, " + run.label(), error, "none",
        fmt::format("plateau {:.1f} MPa from {:.2f} to {:.2f} us", exact.plateau / 1e6,
                    exact.window.arrival * 1e6, exact.window.end() * 1e6)));
    if (run.across == 1) cell_errors.add(run.cell, error);
    if (run.cell == 10) point_errors.add(10.0 / run.across, error);
    const Curve curve{run.label(), history["time"] * 1e6, history["probe.A.stress_xx"] / 1e6};
    if (run.across == 1) mesh.curves.push_back(curve);
    if (run.cell == 10) points.curves.push_back(curve);
  }
  mesh.curves.push_back(exact.curve());
  points.curves.push_back(exact.curve());
  evaluation.add(converges("the stress with the cells", cell_errors.x, cell_errors.y, 0.5,
                           "a front in L1: between 1/2 and 1"));
  evaluation.add(reported("order of the stress with the points' spacing",
                          references::observed_order(point_errors.x, point_errors.y), "none",
                          "the cells stay: the front keeps their width, so no order is due"));
  evaluation.draw("stress", "Figure 3.5: normal stress at point A.", {mesh, points});
  return evaluation;
}

// ---- bar

std::vector<double> bar_cells(Extent extent) {
  return of_extent(extent, {0.2, 0.1, 0.05}, {0.025});
}

std::vector<Run> bar_runs(Extent extent) {
  const std::string file = "verification/bar.toml";
  std::vector<Run> runs;
  for (const int points : {1, 3, 5}) {
    runs.push_back({fmt::format("points-{}", points * points * points),
                    file,
                    {fmt::format("body.bar.points_per_cell={}", points)}});
  }
  for (const std::string functions : {"linear", "quadratic"}) {
    for (const double cell : bar_cells(extent)) {
      runs.push_back({fmt::format("{}-{}", functions, cell),
                      file,
                      {fmt::format("grid.interpolation=\"{}\"", functions),
                       fmt::format("grid.cell=[\"{} m\", \"1 m\", \"1 m\"]", cell),
                       fmt::format("time.step=\"{} us\"", 50 * cell),
                       // Tractions on the points of the outermost cells.
                       fmt::format("load.0.high=[\"{} m\", \"grid\", \"grid\"]", cell),
                       fmt::format("load.1.low=[\"{} m\", \"grid\", \"grid\"]", 10 - cell)}});
    }
  }
  return runs;
}

/// Equivalent stress along the bar at a fraction of the time that a wave takes through it.
struct BarStress {
  double fraction;
  references::SteppedBar bar = references::bar_of_the_source();
  double time = fraction * bar.transit_time();

  Curve computed(const RunResults& run, const std::string& label) const {
    Curve curve =
        curve_at(run.table("profiles.csv"), "position_x", "equivalent_stress", time, 0.1 * time);
    curve.label = label;
    return curve;
  }
  double at(double x) const {
    return references::free_bar_state(bar, std::clamp(x, 0., bar.length), time).equivalent_stress;
  }
  Curve exact() const {
    return exact_curve(bar.length, 500, [&](double x) { return at(x); });
  }
  /// Mean error over the step of the stress.
  double error(const RunResults& run) const {
    return errors_of(computed(run, ""), [&](double x) { return at(x); }).l1 / bar.step;
  }
};

Panel bar_panel(const std::string& title, std::vector<Curve> curves) {
  for (Curve& curve : curves) curve.y = curve.y / 1e6;
  return {title, {"x [m]"}, {"equivalent stress [MPa]"}, std::move(curves)};
}

std::vector<Check> bar_orders(const CaseResults& results, const BarStress& stress,
                              const std::string& functions, const std::vector<double>& cells) {
  std::vector<double> errors;
  for (const double cell : cells) {
    errors.push_back(stress.error(results[fmt::format("{}-{}", functions, cell)]));
  }
  const std::string quantity = fmt::format("the stress at {} L/c, {}", stress.fraction, functions);
  const Check finest =
      reported(fmt::format("mean error at {} L/c over 200 MPa, {}, cells of {} m", stress.fraction,
                           functions, cells.back()),
               errors.back(), fmt::format("{:.3g} with {} m", errors.front(), cells.front()),
               "27 points a cell");
  if (functions == "linear") {
    return {finest,
            reported("order of " + quantity, references::observed_order(cells, errors), "1/2",
                     "noise of points at the pulled ends that cross cells runs into the bar")};
  }
  return {finest, converges(quantity, cells, errors, 0.35,
                            "1/2 in L1 for a front that sheds Airy waves, whose tail falls as "
                            "x^(-3/4); 0.15 for where in its cell the front happens to be")};
}

Evaluation evaluate_bar(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  Figure figure{"stress", "Figure 3.8: equivalent stress along the bar."};
  for (const double fraction : {0.25, 0.5, 0.75}) {
    const BarStress stress{fraction};
    std::vector<Curve> curves{stress.exact()};
    for (const int points : {1, 27, 125}) {
      const RunResults& run = results[fmt::format("points-{}", points)];
      curves.push_back(stress.computed(run, fmt::format("{} per cell", points)));
      evaluation.add(reported(
          fmt::format("mean error at {} L/c over 200 MPa, {} points per cell", fraction, points),
          stress.error(run), "none", "fronts over a few of the 50 cells"));
    }
    figure.panels.push_back(bar_panel(fmt::format("{} L/c", fraction), curves));
    for (const std::string functions : {"linear", "quadratic"}) {
      evaluation.add(bar_orders(results, stress, functions, bar_cells(extent)));
    }
  }
  evaluation.draw(std::move(figure));
  const ResultTable table = results["points-27"].table("profiles.csv");
  const BarStress late{0.75};
  evaluation.add(at_most("largest equivalent stress [Pa]", largest(table["equivalent_stress"]),
                         late.bar.yield_stress * (1 + 1e-9),
                         "perfect plasticity: the return is exact to rounding"));
  Figure crossing{"crossing", "Cells of 0.05 m: linear functions and quadratic B-splines."};
  for (const std::string functions : {"linear", "quadratic"}) {
    crossing.panels.push_back(bar_panel(
        functions + ", 0.75 L/c", {late.computed(results[functions + "-0.05"], ""), late.exact()}));
  }
  evaluation.draw(std::move(crossing));
  evaluation.remarks = {
      "With the source's 50 cells no point crosses a cell before 0.75 L/c. In finer cells points "
      "at the pulled ends do, and with linear functions their noise runs into the bar: refining "
      "makes it worse. Quadratic B-splines, whose gradients do not jump, converge."};
  return evaluation;
}

}  // namespace

std::vector<Case> solids() {
  return {{"impact", "Impact of aluminium on steel", "3.3, Table 3.1, Figures 3.3 to 3.5",
           "exact plateau before releases arrive", impact_runs, evaluate_impact},
          {"bar_wave", "Stress waves in an elastic-plastic bar",
           "3.3, Table 3.2, Figures 3.6 to 3.8", "exact wave solution", bar_runs, evaluate_bar}};
}

}  // namespace zona::studies::verification
