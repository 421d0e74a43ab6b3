#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/profile_errors.h"
#include "studies/references/riemann_problem.h"
#include "studies/verification/cases/case_list.h"

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

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all{
      {"density", "density [kg/m^3]", &FluidState::density, true},
      {"velocity_x", "velocity [m/s]", &FluidState::velocity, false},
      {"pressure", "pressure [Pa]", &FluidState::pressure, false},
      {"energy", "internal energy [J/kg]", &FluidState::internal_energy, true}};
  return all;
}

/// A tube of so many cells; the step follows the cell as the source's does, 2e-5 s at 800 cells.
Run tube_of(int cells, const std::string& label, const std::string& file,
            std::vector<std::string> overrides) {
  const double cell = 1000.0 / cells;  // mm
  overrides.push_back(fmt::format("grid.cell=\"{} mm\"", cell));
  overrides.push_back(fmt::format("grid.high=[\"1 m\", \"{} mm\", \"{} mm\"]", cell, cell));
  overrides.push_back(fmt::format("time.step=\"{} us\"", 16000.0 / cells));
  return {label, file, std::move(overrides)};
}

/// The rows of profiles.csv that belong to a profile, as samples of one quantity.
std::vector<references::Sample> samples(const RunResults& run, const std::string& profile,
                                        const std::string& column) {
  const ResultTable table = run.table("profiles.csv").where("profile", profile);
  const auto& x = table["position_x"];
  const auto& values = table[column];
  std::vector<references::Sample> result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back({x[i], values[i]});
  return result;
}

double l1(const RunResults& run, const std::string& profile, const Quantity& quantity,
          const RiemannSolution& exact, double time) {
  return references::profile_errors(
             samples(run, profile, quantity.column),
             [&](double x) { return exact.at((x - 0.5) / time).*quantity.exact; })
      .l1;
}

Figure tube_figure(const std::string& name, const std::string& caption, const RunResults& run,
                   const std::string& profile, const RiemannSolution& exact, double time) {
  Figure figure{name, caption, {}, {}};
  for (const Quantity& quantity : quantities()) {
    Curve reference{"exact", {}, {}, Style::reference}, computed{"computed", {}, {}, Style::points};
    for (int i = 0; i <= 1000; ++i) {
      reference.x.push_back(i / 1000.0);
      reference.y.push_back(exact.at((i / 1000.0 - 0.5) / time).*quantity.exact);
    }
    for (const auto& sample : samples(run, profile, quantity.column)) {
      computed.x.push_back(sample.x);
      computed.y.push_back(sample.value);
    }
    figure.panels.push_back({"", {"x [m]"}, {quantity.name}, {reference, computed}});
  }
  return figure;
}

std::vector<int> refinements(Extent extent) {
  return extent == Extent::quick ? std::vector<int>{100, 200}
                                 : std::vector<int>{100, 200, 400, 800};
}

/// The L1 orders from 100 to 200 cells must be near one; what follows is reported.
void check_orders(const CaseResults& results, const std::string& prefix,
                  const RiemannSolution& exact, double time, Extent extent, double order,
                  Evaluation& evaluation) {
  for (const Quantity& quantity : quantities()) {
    std::vector<double> sizes, errors;
    for (const int cells : refinements(extent)) {
      sizes.push_back(1.0 / cells);
      errors.push_back(
          l1(results[fmt::format("{}{}", prefix, cells)], "cells_1", quantity, exact, time));
      if (sizes.size() == 2) {
        evaluation.checks.push_back(
            converges("the L1 error of " + quantity.name + ", " + prefix + "100 to 200", sizes,
                      errors, quantity.jumps_at_contact ? std::min(order, 2. / 3) : order,
                      quantity.jumps_at_contact
                          ? "a contact that spreads in a second-order scheme: 2/3"
                          : "captured shocks: 1, less what the artificial viscosity spreads"));
      }
      if (sizes.size() > 2) {
        evaluation.checks.push_back(reported(
            fmt::format("L1 error of {}, {}{}", quantity.name, prefix, cells), errors.back(),
            fmt::format("{:.3g} at half the cells", errors[errors.size() - 2]),
            "beyond 200 cells linear functions stop converging at the contact"));
      }
    }
  }
}

// ---- the source's tube

constexpr double source_end = 0.143;
constexpr double sod_end = 0.2;

std::vector<Run> tube_runs(Extent extent) {
  const std::string file = "verification/shock_tube.toml";
  const std::vector<std::string> bare{"body.left.artificial_viscosity_quadratic=0.0",
                                      "body.left.artificial_viscosity_linear=0.0",
                                      "body.right.artificial_viscosity_quadratic=0.0",
                                      "body.right.artificial_viscosity_linear=0.0"};
  std::vector<Run> runs;
  for (const int cells : refinements(extent)) {
    runs.push_back(tube_of(cells, fmt::format("viscous-{}", cells), file, {}));
  }
  const int finest = refinements(extent).back();
  runs.push_back(tube_of(finest, "inviscid", file, bare));
  for (const int cells : refinements(extent)) {
    runs.push_back(tube_of(cells, fmt::format("quadratic-{}", cells), file,
                           {"grid.interpolation=\"quadratic\""}));
  }
  return runs;
}

Evaluation evaluate_tube(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const RiemannSolution exact = references::shock_tube_of_the_source();
  check_orders(results, "viscous-", exact, source_end, extent, 0.9, evaluation);
  check_orders(results, "quadratic-", exact, source_end, extent, 0.8, evaluation);
  const int finest = refinements(extent).back();
  const RunResults& viscous = results[fmt::format("viscous-{}", finest)];
  const RunResults& inviscid = results["inviscid"];
  for (const Quantity& quantity : quantities()) {
    for (const int cells : {2, 4}) {
      evaluation.checks.push_back(reported(
          fmt::format("L1 error of {}, means over {} cells", quantity.name, cells),
          l1(viscous, fmt::format("cells_{}", cells), quantity, exact, source_end),
          fmt::format("{:.3g} over one", l1(viscous, "cells_1", quantity, exact, source_end)),
          "Figures 4.13 and 4.14"));
    }
  }
  const auto largest = [&](const RunResults& run, const char* column) {
    double value = 0;
    for (const auto& sample : samples(run, "cells_1", column))
      value = std::max(value, sample.value);
    return value;
  };
  evaluation.checks.push_back(reported("largest density without artificial viscosity [kg/m^3]",
                                       largest(inviscid, "density"), "578 (Figure 4.11)",
                                       "0.73 behind the exact shock"));
  evaluation.checks.push_back(reported("largest density with it [kg/m^3]",
                                       largest(viscous, "density"), "1 (exact, undisturbed gas)",
                                       "Figure 4.12"));
  evaluation.figures = {
      tube_figure("viscous", "Figure 4.12: with artificial viscosity, means over one cell.",
                  viscous, "cells_1", exact, source_end),
      tube_figure("inviscid", "Figure 4.11: without artificial viscosity.", inviscid, "cells_1",
                  exact, source_end),
      tube_figure("four_cells", "Figure 4.14: means over four cells.", viscous, "cells_4", exact,
                  source_end),
      tube_figure("quadratic", "Quadratic B-splines, means over one cell.",
                  results[fmt::format("quadratic-{}", finest)], "cells_1", exact, source_end)};
  return evaluation;
}

// ---- Sod's tube

std::vector<Run> sod_runs(Extent extent) {
  std::vector<Run> runs;
  for (const int cells : refinements(extent)) {
    runs.push_back(
        tube_of(cells, fmt::format("viscous-{}", cells), "verification/sod_tube.toml", {}));
  }
  return runs;
}

Evaluation evaluate_sod(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const RiemannSolution exact = references::sods_tube();
  check_orders(results, "viscous-", exact, sod_end, extent, 0.7, evaluation);
  evaluation.figures = {tube_figure("profiles", "Sod's tube, means over one cell.",
                                    results[fmt::format("viscous-{}", refinements(extent).back())],
                                    "cells_1", exact, sod_end)};
  return evaluation;
}

}  // namespace

Case shock_tube() {
  return {"shock_tube",
          "Shock tube",
          "4.4.1, Figures 4.11 to 4.14",
          "exact solution of the Riemann problem",
          tube_runs,
          evaluate_tube};
}

Case sod_tube() {
  return {"sod_tube", "Sod's shock tube", "", "exact solution of the Riemann problem",
          sod_runs,   evaluate_sod};
}

}  // namespace zona::studies::verification
