#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "studies/references/gas_box.h"
#include "studies/references/string_impact.h"
#include "studies/verification/cases/case_list.h"

namespace zona::studies::verification {

namespace {

/// Displacement of a probe along z, in mm over ms.
Curve history_curve(const RunResults& run, const std::string& label, const std::string& probe) {
  const ResultTable history = run.table("history.csv");
  Curve curve{label, {}, {}, Style::line};
  const auto& z = history["probe." + probe + ".displacement_z"];
  for (std::size_t i = 0; i < history.rows(); ++i) {
    curve.x.push_back(history["time"][i] * 1e3);
    curve.y.push_back(z[i] * 1e3);
  }
  return curve;
}

/// Mean distance of a curve from a reference over a time [ms], over the reference's largest value.
template <class Reference>
double distance(const Curve& curve, double end, const Reference& reference) {
  double sum = 0, largest = 0;
  int count = 0;
  for (std::size_t i = 0; i < curve.x.size() && curve.x[i] <= end; ++i) {
    const double exact = reference(curve.x[i]);
    sum += std::abs(curve.y[i] - exact);
    largest = std::max(largest, std::abs(exact));
    ++count;
  }
  return sum / count / largest;
}

/// Kinetic and stored energy of all bodies, as a share of that at the start.
Curve energy_curve(const RunResults& run, const std::string& label, double initial) {
  const ResultTable history = run.table("history.csv");
  Curve curve{label, {}, {}, Style::line};
  for (std::size_t i = 0; i < history.rows(); ++i) {
    curve.x.push_back(history["time"][i] * 1e3);
    curve.y.push_back((history["kinetic_energy"][i] + history["stored_energy"][i]) / initial);
  }
  return curve;
}

// ---- cuboid on a net

std::vector<int> net_cells(Extent extent) {
  return extent == Extent::quick ? std::vector<int>{50} : std::vector<int>{50, 25, 20};
}

std::vector<Run> net_runs(Extent extent) {
  const std::string file = "verification/net.toml";
  std::vector<Run> runs;
  for (const int cell : net_cells(extent)) {
    runs.push_back(
        {fmt::format("cell-{}mm", cell), file, {fmt::format("grid.cell=\"{} mm\"", cell)}});
  }
  runs.push_back({"objective",
                  file,
                  {fmt::format("grid.cell=\"{} mm\"", net_cells(extent).back()),
                   "body.net.kinematics=\"objective\""}});
  // The source's step is a fiftieth of the critical one.
  for (Run& run : runs) {
    if (extent == Extent::quick) run.overrides.push_back("time.step=\"100 us\"");
  }
  return runs;
}

Evaluation evaluate_net(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  auto impact = references::net_of_the_source();
  const double energy = 0.5 * impact.block_mass * impact.speed * impact.speed;
  impact.strain = references::StringStrain::summed;
  const auto summed = references::string_impact(impact);
  impact.strain = references::StringStrain::biot;
  const auto objective = references::string_impact(impact);
  const auto reference_of = [](const references::StringHistory& history) {
    return
        [&history](double milliseconds) { return history.displacement(milliseconds * 1e-3) * 1e3; };
  };
  Panel panel{"", {"time [ms]"}, {"displacement of the cuboid [mm]"}, {}};
  Panel energies{"", {"time [ms]"}, {"energy over that of the impact"}, {}};
  std::vector<double> cells, errors;
  for (const int cell : net_cells(extent)) {
    const std::string label = fmt::format("cell-{}mm", cell);
    panel.curves.push_back(history_curve(results[label], label, "centre"));
    energies.curves.push_back(energy_curve(results[label], label, energy));
    cells.push_back(cell);
    errors.push_back(
        distance(panel.curves.back(), summed.deepest_time * 1e3, reference_of(summed)));
    evaluation.checks.push_back(
        reported("mean distance from the string until the deepest point, " + label, errors.back(),
                 "none", "over the depth"));
  }
  const auto deepest = [](const Curve& curve) {
    return *std::min_element(curve.y.begin(), curve.y.end());
  };
  const Curve finest = panel.curves.back();
  panel.curves.push_back(history_curve(results["objective"], "objective", "centre"));
  evaluation.checks.push_back(near("deepest point [mm], source kinematics", deepest(finest),
                                   summed.deepest * 1e3, extent == Extent::quick ? 0.1 : 0.05,
                                   "the contact is felt up to a cell early, 50 or 20 mm of 1 m"));
  evaluation.checks.push_back(near("deepest point [mm], objective kinematics",
                                   deepest(panel.curves.back()), objective.deepest * 1e3,
                                   extent == Extent::quick ? 0.1 : 0.05, "as above"));
  for (const Curve& curve : energies.curves) {
    evaluation.checks.push_back(
        reported("largest energy over that of the impact, source kinematics, " + curve.label,
                 *std::max_element(curve.y.begin(), curve.y.end()), "1",
                 "half stress times summed strain is no energy: twice the work at small slopes"));
  }
  energies.curves.push_back(energy_curve(results["objective"], "objective", energy));
  const auto& kept = energies.curves.back().y;
  evaluation.checks.push_back(at_most("largest energy over that of the impact, objective",
                                      *std::max_element(kept.begin(), kept.end()), 1.01,
                                      "an impact can only lose; velocities and stresses stand half "
                                      "a step apart"));
  for (const auto* history : {&summed, &objective}) {
    Curve reference{history == &summed ? "string, summed strain" : "string, Biot strain",
                    {},
                    {},
                    history == &summed ? Style::reference : Style::limit};
    for (const auto& sample : history->samples) {
      reference.x.push_back(sample.time * 1e3);
      reference.y.push_back(sample.displacement * 1e3);
    }
    panel.curves.push_back(std::move(reference));
  }
  evaluation.figures.push_back(
      {"displacement", "Figure 4.16: the cuboid on the net.", {panel, energies}, {}});
  evaluation.remarks = {
      "The source's LS-DYNA curves are lost. The reference is a string with the same contact, "
      "computed by itself; the net's Poisson ratio is 0 and its width the cuboid's, so it is one.",
      fmt::format(
          "The source's strain (4.10) doubles that of small slopes: the net is stiffer than "
          "a true one, and the cuboid sinks {:.1f} mm instead of {:.1f} mm.",
          -summed.deepest * 1e3, -objective.deepest * 1e3)};
  return evaluation;
}

// ---- box of gas with a lid

std::vector<int> box_cells(Extent extent) {
  return extent == Extent::quick ? std::vector<int>{20} : std::vector<int>{20, 10, 5};
}

/// Cells in which two ways to sum strains are held against each other [mm].
int summed_cell(Extent extent) {
  return extent == Extent::quick ? 20 : 10;
}

std::vector<Run> box_runs(Extent extent) {
  const std::string file = "verification/gas_box.toml";
  std::vector<Run> runs;
  for (const int cell : box_cells(extent)) {
    runs.push_back(
        {fmt::format("cell-{}mm", cell), file, {fmt::format("grid.cell=\"{} mm\"", cell)}});
    // The source's 100 x 100 points stand too far apart there: the gas slips between them.
    if (cell < 10) runs.back().overrides.push_back("body.lid.sheet_points=[200, 200]");
  }
  runs.push_back({"increments",
                  file,
                  {fmt::format("grid.cell=\"{} mm\"", summed_cell(extent)),
                   "body.lid.stress_update=\"increments\""}});
  if (extent == Extent::quick) {
    // In cells of 20 mm wrinkles come after 20 ms. Both runs write their histories at the same
    // times.
    for (Run& run : runs) run.overrides.push_back("output.history_interval=\"50 us\"");
    runs.back().overrides.push_back("time.end=\"20 ms\"");
  }
  runs.push_back({"objective", file, {"body.lid.kinematics=\"objective\""}});
  return runs;
}

/// Change of the energy of all bodies over what the gas has given until the end.
Curve box_energy(const RunResults& run, const std::string& label) {
  const ResultTable history = run.table("history.csv");
  const auto& gas = history["body.gas.stored_energy"];
  Curve curve{label, {}, {}, Style::line};
  for (std::size_t i = 0; i < history.rows(); ++i) {
    const double change = history["kinetic_energy"][i] + history["stored_energy"][i] -
                          history["kinetic_energy"][0] - history["stored_energy"][0];
    curve.x.push_back(history["time"][i] * 1e3);
    curve.y.push_back(change / (gas[0] - gas.back()));
  }
  return curve;
}

Evaluation evaluate_box(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  auto box = references::box_of_the_source();
  const auto stretches = references::gas_box(box);
  box.strain = references::TriangleStrain::summed;
  const auto summed = references::gas_box(box);
  box.rigid_cube = false;
  const auto soft_summed = references::gas_box(box);
  box.strain = references::TriangleStrain::stretches;
  const auto soft_stretches = references::gas_box(box);
  const auto reference = [&](double milliseconds) {
    return summed.displacement(milliseconds * 1e-3) * 1e3;
  };
  Panel panel{"", {"time [ms]"}, {"displacement of the cube [mm]"}, {}};
  Panel energies{"", {"time [ms]"}, {"energy gained over the gas' work"}, {}};
  std::vector<double> cells, errors;
  for (const int cell : box_cells(extent)) {
    const std::string label = fmt::format("cell-{}mm", cell);
    panel.curves.push_back(history_curve(results[label], label, "cube"));
    energies.curves.push_back(box_energy(results[label], label));
    evaluation.checks.push_back(reported(
        "energy gained over the gas' work, source kinematics, " + label,
        energies.curves.back().y.back(), "0", "half stress times summed strain is no energy"));
    cells.push_back(cell);
    errors.push_back(distance(panel.curves.back(), 30, reference));
    evaluation.checks.push_back(
        reported("mean distance from the model over its largest value, " + label, errors.back(),
                 "none", "0 to 30 ms"));
  }
  const std::string summed_label = fmt::format("cell-{}mm", summed_cell(extent));
  const Curve total = history_curve(results[summed_label], "total strains", "cube");
  const Curve increments = history_curve(results["increments"], "increments", "cube");
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < increments.x.size(); ++i) {
    difference = std::max(difference, std::abs(total.y.at(i) - increments.y[i]));
    largest = std::max(largest, std::abs(total.y[i]));
  }
  evaluation.checks.push_back(
      at_most("total strains against increments (Figure 5.9), over the "
              "largest displacement",
              difference / largest, 1e-3,
              "one law, two ways to sum it: equal but for rounding, and for "
              "wrinkles, which have a memory in the second"));
  panel.curves.push_back(history_curve(results["objective"], "objective", "cube"));
  energies.curves.push_back(box_energy(results["objective"], "objective"));
  evaluation.checks.push_back(within("energy gained over the gas' work, objective",
                                     energies.curves.back().y.back(), 0, 0.05,
                                     "walls and perimeter do no work; the pressure at the end of a "
                                     "step works in (4.40), first order in the step"));
  const auto model_curve = [](const references::GasBoxHistory& history, const char* label,
                              Style style) {
    Curve curve{label, {}, {}, style};
    for (const auto& sample : history.samples) {
      curve.x.push_back(sample.time * 1e3);
      curve.y.push_back(sample.displacement * 1e3);
    }
    return curve;
  };
  std::vector<double> source_ends;
  for (std::size_t c = 0; c < cells.size(); ++c) source_ends.push_back(panel.curves[c].y.back());
  const double objective_end = panel.curves.back().y.back();
  panel.curves.push_back(model_curve(summed, "model, summed strain", Style::reference));
  panel.curves.push_back(model_curve(stretches, "model, stretches", Style::reference));
  panel.curves.push_back(model_curve(soft_stretches, "the same, cube not rigid", Style::limit));
  const auto end = [](const references::GasBoxHistory& history) {
    return history.samples.back().displacement * 1e3;
  };
  const std::string origin =
      "the cells spread the cube's footprint: between a rigid cube and a mass without stiffness";
  std::vector<std::tuple<std::string, double, double, double>> ends;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    ends.emplace_back(fmt::format("source kinematics, cells of {} mm", cells[c]), source_ends[c],
                      end(soft_summed), end(summed));
  }
  ends.emplace_back("objective kinematics, cells of 10 mm", objective_end, end(soft_stretches),
                    end(stretches));
  for (const auto& [name, value, soft, rigid] : ends) {
    evaluation.checks.push_back(
        within(fmt::format("displacement of the cube at 30 ms [mm], {}", name), value,
               0.5 * (soft + rigid), 0.5 * (rigid - soft),
               fmt::format("{}, {:.1f} to {:.1f} mm of the model", origin, soft, rigid)));
  }
  evaluation.figures.push_back(
      {"displacement", "Figure 4.19: the cube on the lid.", {panel, energies}, {}});
  evaluation.remarks = {
      "The model is independent but no exact solution: uniform adiabatic gas without inertia, a "
      "rigid cube that does not let go. A cube that is a mass without stiffness is the other "
      "bound.",
      fmt::format("Each kinematics is held against its own model: the summed strain (4.10), which "
                  "doubles that of small slopes, lifts the cube {:.1f} mm, true stretches {:.1f} "
                  "mm.",
                  end(summed), end(stretches))};
  if (extent == Extent::full) {
    evaluation.remarks.push_back(
        "The displacement does not converge: with cells of 5 mm it falls below the model's. No gas "
        "is above the lid then, but the densities of its points have drifted from the volume that "
        "they fill, most of them far below it, and their pressure with them. What drives that is "
        "noise: with linear functions the gas keeps half of its work as a motion of its own, "
        "thousands of times what the lid's speed gives it. The same drift has begun with cells of "
        "10 "
        "mm, where the cube does not show it. Its cause is open.");
  }
  return evaluation;
}

}  // namespace

Case net() {
  return {"net",
          "Cuboid on a net",
          "4.4.2, Tables 4.1 and 4.2, Figures 4.15 to 4.17",
          "a finite-deformation string with a block, computed by itself",
          net_runs,
          evaluate_net};
}

Case gas_box() {
  return {"gas_box",
          "Box of gas with a membrane and a cube",
          "4.4.3, Table 4.3, Figures 4.18 to 4.20; 5.3, Figure 5.9",
          "membrane with an adiabatic gas, computed by itself",
          box_runs,
          evaluate_box};
}

}  // namespace zona::studies::verification
