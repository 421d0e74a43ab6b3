#include <fmt/format.h>

#include <algorithm>

#include "studies/references/riemann_problem.h"
#include "studies/verification/cases/case_list.h"
#include "studies/verification/evaluation/curves.h"

namespace zona::studies::verification {

namespace {

using references::FluidState;
using references::RiemannSolution;

struct Quantity {
  std::string column;  ///< of profiles.csv
  std::string name;
  double FluidState::*exact;
  bool jumps_at_contact;
};

const std::vector<Quantity> quantities{
    {"density", "density [kg/m^3]", &FluidState::density, true},
    {"velocity_x", "velocity [m/s]", &FluidState::velocity, false},
    {"pressure", "pressure [Pa]", &FluidState::pressure, false},
    {"energy", "internal energy [J/kg]", &FluidState::internal_energy, true}};

/// A tube of so many cells; the step follows the cell as the source's does, 2e-5 s at 800 cells.
Run tube_of(int cells, const std::string& label, const std::string& file,
            std::vector<std::string> overrides) {
  const double cell = 1000.0 / cells;  // mm
  overrides.push_back(cell_override(cell));
  overrides.push_back(fmt::format("grid.high=[\"1 m\", \"{} mm\", \"{} mm\"]", cell, cell));
  overrides.push_back(fmt::format("time.step=\"{} us\"", 16000.0 / cells));
  return {label, file, std::move(overrides)};
}

std::vector<int> refinements(Extent extent) {
  return of_extent(extent, {100, 200}, {400, 800});
}

/// Tubes of all resolutions, labelled by their cells.
std::vector<Run> tubes(Extent extent, const std::string& prefix, const std::string& file,
                       const std::vector<std::string>& overrides) {
  std::vector<Run> runs;
  for (const int cells : refinements(extent)) {
    runs.push_back(tube_of(cells, prefix + std::to_string(cells), file, overrides));
  }
  return runs;
}

/// One quantity over x, of the rows of profiles.csv that belong to a profile.
Curve profile(const RunResults& run, const std::string& name, const std::string& column) {
  const ResultTable table = run.table("profiles.csv").where("profile", name);
  return {"computed", table["position_x"], table[column], Style::points};
}

/// The exact solution at the time of the profiles, discontinuous at 0.5 m at first.
struct TubeSolution {
  RiemannSolution riemann;
  double time;  ///< [s]

  double at(double x, const Quantity& quantity) const {
    return riemann.at((x - 0.5) / time).*quantity.exact;
  }
  double l1(const RunResults& run, const std::string& name, const Quantity& quantity) const {
    return errors_of(profile(run, name, quantity.column), [&](double x) { return at(x, quantity); })
        .l1;
  }
};

Figure tube_figure(const std::string& name, const std::string& caption, const RunResults& run,
                   const std::string& profile_name, const TubeSolution& exact) {
  Figure figure{name, caption};
  for (const Quantity& quantity : quantities) {
    Panel panel{"", {"x [m]"}, {quantity.name}};
    panel.curves = {exact_curve(1, 1000, [&](double x) { return exact.at(x, quantity); }),
                    profile(run, profile_name, quantity.column)};
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

/// The L1 orders from 100 to 200 cells must be near one; what follows is reported.
std::vector<Check> tube_orders(const CaseResults& results, const std::string& prefix,
                               const TubeSolution& exact, Extent extent, double order) {
  std::vector<Check> checks;
  for (const Quantity& quantity : quantities) {
    const bool contact = quantity.jumps_at_contact;
    Curve errors;
    for (const int cells : refinements(extent)) {
      const RunResults& run = results[prefix + std::to_string(cells)];
      errors.add(1.0 / cells, exact.l1(run, "cells_1", quantity));
      if (cells == 200)
        checks.push_back(
            converges("the L1 error of " + quantity.name + ", " + prefix + "100 to 200", errors.x,
                      errors.y, contact ? std::min(order, 2. / 3) : order,
                      contact ? "a contact that spreads in a second-order scheme: 2/3"
                              : "captured shocks: 1, less what the artificial viscosity spreads"));
      if (cells > 200)
        checks.push_back(reported(
            fmt::format("L1 error of {}, {}{}", quantity.name, prefix, cells), errors.y.back(),
            fmt::format("{:.3g} at half the cells", errors.y[errors.y.size() - 2]),
            "beyond 200 cells linear functions stop converging at the contact"));
    }
  }
  return checks;
}

// ---- the source's tube

std::vector<Run> tube_runs(Extent extent) {
  const std::string file = "verification/shock_tube.toml";
  std::vector<Run> runs = tubes(extent, "viscous-", file, {});
  runs.push_back(tube_of(
      refinements(extent).back(), "inviscid", file,
      {"body.left.artificial_viscosity_quadratic=0.0", "body.left.artificial_viscosity_linear=0.0",
       "body.right.artificial_viscosity_quadratic=0.0",
       "body.right.artificial_viscosity_linear=0.0"}));
  for (Run& run : tubes(extent, "quadratic-", file, {"grid.interpolation=\"quadratic\""})) {
    runs.push_back(std::move(run));
  }
  return runs;
}

Evaluation evaluate_tube(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const TubeSolution exact{references::shock_tube_of_the_source(), 0.143};
  evaluation.add(tube_orders(results, "viscous-", exact, extent, 0.9));
  evaluation.add(tube_orders(results, "quadratic-", exact, extent, 0.8));
  const std::string finest = std::to_string(refinements(extent).back());
  const RunResults& viscous = results["viscous-" + finest];
  const RunResults& inviscid = results["inviscid"];
  for (const Quantity& quantity : quantities) {
    for (const int cells : {2, 4}) {
      evaluation.add(
          reported(fmt::format("L1 error of {}, means over {} cells", quantity.name, cells),
                   exact.l1(viscous, fmt::format("cells_{}", cells), quantity),
                   fmt::format("{:.3g} over one", exact.l1(viscous, "cells_1", quantity)),
                   "Figures 4.13 and 4.14"));
    }
  }
  evaluation.add({reported("largest density without artificial viscosity [kg/m^3]",
                           largest(profile(inviscid, "cells_1", "density").y), "578 (Figure 4.11)",
                           "0.73 behind the exact shock"),
                  reported("largest density with it [kg/m^3]",
                           largest(profile(viscous, "cells_1", "density").y),
                           "1 (exact, undisturbed gas)", "Figure 4.12")});
  evaluation.figures = {
      tube_figure("viscous", "Figure 4.12: with artificial viscosity, means over one cell.",
                  viscous, "cells_1", exact),
      tube_figure("inviscid", "Figure 4.11: without artificial viscosity.", inviscid, "cells_1",
                  exact),
      tube_figure("four_cells", "Figure 4.14: means over four cells.", viscous, "cells_4", exact),
      tube_figure("quadratic", "Quadratic B-splines, means over one cell.",
                  results["quadratic-" + finest], "cells_1", exact)};
  return evaluation;
}

// ---- Sod's tube

std::vector<Run> sod_runs(Extent extent) {
  return tubes(extent, "viscous-", "verification/sod_tube.toml", {});
}

Evaluation evaluate_sod(const CaseResults& results, Extent extent) {
  const TubeSolution exact{references::sods_tube(), 0.2};
  const RunResults& finest = results["viscous-" + std::to_string(refinements(extent).back())];
  return {tube_orders(results, "viscous-", exact, extent, 0.7),
          {tube_figure("profiles", "Sod's tube, means over one cell.", finest, "cells_1", exact)},
          {}};
}

}  // namespace

std::vector<Case> gas_dynamics() {
  return {{"shock_tube", "Shock tube", "4.4.1, Figures 4.11 to 4.14",
           "exact solution of the Riemann problem", tube_runs, evaluate_tube},
          {"sod_tube", "Sod's shock tube", "", "exact solution of the Riemann problem", sod_runs,
           evaluate_sod}};
}

}  // namespace zona::studies::verification
