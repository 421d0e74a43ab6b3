#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/gas_box.h"
#include "studies/references/string_impact.h"
#include "studies/verification/cases/case_list.h"
#include "studies/verification/evaluation/curves.h"

namespace zona::studies::verification {

namespace {

using references::GasBoxHistory;
using references::StringHistory;

std::string cell_label(int cell) {
  return fmt::format("cell-{}mm", cell);
}

/// Displacement of a probe along z, in mm over ms.
Curve history_curve(const RunResults& run, const std::string& label, const std::string& probe) {
  const ResultTable history = run.table("history.csv");
  return {label, history["time"] * 1e3, history["probe." + probe + ".displacement_z"] * 1e3};
}

/// Displacement of a model, in mm over ms.
template <class History>
Curve model_curve(const History& history, const std::string& label, Style style) {
  Curve curve{label, {}, {}, style};
  for (const auto& sample : history.samples) {
    curve.add(sample.time * 1e3, sample.displacement * 1e3);
  }
  return curve;
}

/// Mean distance of a curve from a model until a time [ms], over the model's largest displacement.
template <class History>
double distance(const Curve& curve, const History& model, double end) {
  double sum = 0, largest = 0;
  int count = 0;
  for (std::size_t i = 0; i < curve.x.size() && curve.x[i] <= end; ++i) {
    const double exact = model.displacement(curve.x[i] * 1e-3) * 1e3;
    sum += std::abs(curve.y[i] - exact);
    largest = std::max(largest, std::abs(exact));
    ++count;
  }
  return sum / count / largest;
}

// ---- cuboid on a net

std::vector<int> net_cells(Extent extent) {
  return of_extent(extent, {50}, {25, 20});
}

std::vector<Run> net_runs(Extent extent) {
  const std::string file = "verification/net.toml";
  std::vector<Run> runs;
  for (const int cell : net_cells(extent)) {
    runs.push_back({cell_label(cell), file, {cell_override(cell)}});
  }
  runs.push_back({"objective",
                  file,
                  {cell_override(net_cells(extent).back()), "body.net.kinematics=\"objective\""}});
  // The source's step is a fiftieth of the critical one.
  for (Run& run : runs) {
    if (extent == Extent::quick) run.overrides.push_back("time.step=\"100 us\"");
  }
  return runs;
}

StringHistory net_model(references::StringStrain strain) {
  auto impact = references::net_of_the_source();
  impact.strain = strain;
  return references::string_impact(impact);
}

/// Kinetic and stored energy of all bodies, as a share of that at the start.
Curve net_energy(const RunResults& run, const std::string& label) {
  const ResultTable history = run.table("history.csv");
  const auto impact = references::net_of_the_source();
  const double initial = 0.5 * impact.block_mass * impact.speed * impact.speed;
  Curve curve{label, history["time"] * 1e3};
  for (std::size_t i = 0; i < history.rows(); ++i) {
    curve.y.push_back((history["kinetic_energy"][i] + history["stored_energy"][i]) / initial);
  }
  return curve;
}

/// The curves of the source's kinematics, the finest last, and that of the objective ones.
std::vector<Check> net_depths(const std::vector<Curve>& source, const Curve& objective,
                              const StringHistory& summed, const StringHistory& biot,
                              double tolerance) {
  const auto deepest = [](const Curve& curve) {
    return *std::min_element(curve.y.begin(), curve.y.end());
  };
  std::vector<Check> checks;
  for (const Curve& curve : source) {
    checks.push_back(
        reported("mean distance from the string until the deepest point, " + curve.label,
                 distance(curve, summed, summed.deepest_time * 1e3), "none", "over the depth"));
  }
  checks.push_back(near("deepest point [mm], source kinematics", deepest(source.back()),
                        summed.deepest * 1e3, tolerance,
                        "the contact is felt up to a cell early, 50 or 20 mm of 1 m"));
  checks.push_back(near("deepest point [mm], objective kinematics", deepest(objective),
                        biot.deepest * 1e3, tolerance, "as above"));
  return checks;
}

Evaluation evaluate_net(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const StringHistory summed = net_model(references::StringStrain::summed);
  const StringHistory biot = net_model(references::StringStrain::biot);
  Panel panel{"", {"time [ms]"}, {"displacement of the cuboid [mm]"}};
  Panel energies{"", {"time [ms]"}, {"energy over that of the impact"}};
  for (const int cell : net_cells(extent)) {
    const std::string label = cell_label(cell);
    panel.curves.push_back(history_curve(results[label], label, "centre"));
    energies.curves.push_back(net_energy(results[label], label));
  }
  const Curve objective = history_curve(results["objective"], "objective", "centre");
  evaluation.add(
      net_depths(panel.curves, objective, summed, biot, extent == Extent::quick ? 0.1 : 0.05));
  for (const Curve& curve : energies.curves) {
    evaluation.add(
        reported("largest energy over that of the impact, source kinematics, " + curve.label,
                 largest(curve.y), "1",
                 "half stress times summed strain is no energy: twice the work at small slopes"));
  }
  energies.curves.push_back(net_energy(results["objective"], "objective"));
  evaluation.add(at_most(
      "largest energy over that of the impact, objective", largest(energies.curves.back().y), 1.01,
      "an impact can only lose; velocities and stresses stand half a step apart"));
  panel.curves.push_back(objective);
  panel.curves.push_back(model_curve(summed, "string, summed strain", Style::reference));
  panel.curves.push_back(model_curve(biot, "string, Biot strain", Style::limit));
  evaluation.draw("displacement", "Figure 4.16: the cuboid on the net.", {panel, energies});
  evaluation.remarks = {
      "The source's LS-DYNA curves are lost. The reference is a string with the same contact, "
      "computed by itself; the net's Poisson ratio is 0 and its width the cuboid's, so it is one.",
      fmt::format("The source's strain (4.10) doubles that of small slopes: the net is stiffer "
                  "than a true one, and the cuboid sinks {:.1f} mm instead of {:.1f} mm.",
                  -summed.deepest * 1e3, -biot.deepest * 1e3)};
  return evaluation;
}

// ---- box of gas with a lid

std::vector<int> box_cells(Extent extent) {
  return of_extent(extent, {20}, {10, 5});
}

/// Cells in which two ways to sum strains are held against each other [mm].
int summed_cell(Extent extent) {
  return extent == Extent::quick ? 20 : 10;
}

std::vector<Run> box_runs(Extent extent) {
  const std::string file = "verification/gas_box.toml";
  std::vector<Run> runs;
  for (const int cell : box_cells(extent)) {
    runs.push_back({cell_label(cell), file, {cell_override(cell)}});
    // The source's 100 x 100 points stand too far apart there: the gas slips between them.
    if (cell < 10) runs.back().overrides.push_back("body.lid.sheet_points=[200, 200]");
  }
  runs.push_back({"increments",
                  file,
                  {cell_override(summed_cell(extent)), "body.lid.stress_update=\"increments\""}});
  if (extent == Extent::quick) {
    // In cells of 20 mm wrinkles come after 20 ms. Both runs write their histories at the same
    // times.
    for (Run& run : runs) run.overrides.push_back("output.history_interval=\"50 us\"");
    runs.back().overrides.push_back("time.end=\"20 ms\"");
  }
  runs.push_back({"objective", file, {"body.lid.kinematics=\"objective\""}});
  return runs;
}

/// The model with a cube that is a mass without stiffness, and with a rigid one.
struct BoxBounds {
  GasBoxHistory soft, rigid;
};

BoxBounds box_bounds(references::TriangleStrain strain) {
  auto box = references::box_of_the_source();
  box.strain = strain;
  const GasBoxHistory rigid = references::gas_box(box);
  box.rigid_cube = false;
  return {references::gas_box(box), rigid};
}

/// Displacement of the cube at the end [mm].
double end(const GasBoxHistory& history) {
  return history.samples.back().displacement * 1e3;
}

/// Change of the energy of all bodies over what the gas has given until the end.
Curve box_energy(const RunResults& run, const std::string& label) {
  const ResultTable history = run.table("history.csv");
  const auto& gas = history["body.gas.stored_energy"];
  const auto& kinetic = history["kinetic_energy"];
  const auto& stored = history["stored_energy"];
  Curve curve{label, history["time"] * 1e3};
  for (std::size_t i = 0; i < history.rows(); ++i) {
    const double change = kinetic[i] + stored[i] - kinetic[0] - stored[0];
    curve.y.push_back(change / (gas[0] - gas.back()));
  }
  return curve;
}

Check box_updates_agree(const CaseResults& results, Extent extent) {
  const Curve total = history_curve(results[cell_label(summed_cell(extent))], "", "cube");
  const Curve increments = history_curve(results["increments"], "", "cube");
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < increments.x.size(); ++i) {
    difference = std::max(difference, std::abs(total.y.at(i) - increments.y[i]));
    largest = std::max(largest, std::abs(total.y[i]));
  }
  return at_most("total strains against increments (Figure 5.9), over the largest displacement",
                 difference / largest, 1e-3,
                 "one law, two ways to sum it: equal but for rounding, and for wrinkles, which "
                 "have a memory in the second");
}

Check box_lift(const std::string& kinematics, double computed, const BoxBounds& model) {
  const double soft = end(model.soft), rigid = end(model.rigid);
  return within(fmt::format("displacement of the cube at 30 ms [mm], {}", kinematics), computed,
                0.5 * (soft + rigid), 0.5 * (rigid - soft),
                fmt::format("the cells spread the cube's footprint: between a rigid cube and a "
                            "mass without stiffness, {:.1f} to {:.1f} mm of the model",
                            soft, rigid));
}

const char* const box_drift =
    "The displacement does not converge: with cells of 5 mm it falls below the model's. No gas is "
    "above the lid then, but the densities of its points have drifted from the volume that they "
    "fill, most of them far below it, and their pressure with them. What drives that is noise: "
    "with linear functions the gas keeps half of its work as a motion of its own, thousands of "
    "times what the lid's speed gives it. The same drift has begun with cells of 10 mm, where the "
    "cube does not show it. Its cause is open.";

std::vector<std::string> box_remarks(double summed, double stretches, Extent extent) {
  std::vector<std::string> remarks{
      "The model is independent but no exact solution: uniform adiabatic gas without inertia, a "
      "rigid cube that does not let go. A cube that is a mass without stiffness is the other "
      "bound.",
      fmt::format(
          "Each kinematics is held against its own model: the summed strain (4.10), which doubles "
          "that of small slopes, lifts the cube {:.1f} mm, true stretches {:.1f} mm.",
          summed, stretches)};
  if (extent == Extent::full) remarks.push_back(box_drift);
  return remarks;
}

Evaluation evaluate_box(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const BoxBounds summed = box_bounds(references::TriangleStrain::summed);
  const BoxBounds stretches = box_bounds(references::TriangleStrain::stretches);
  Panel panel{"", {"time [ms]"}, {"displacement of the cube [mm]"}};
  Panel energies{"", {"time [ms]"}, {"energy gained over the gas' work"}};
  std::vector<Check> lifts;
  for (const int cell : box_cells(extent)) {
    const std::string label = cell_label(cell);
    const Curve& curve = panel.curves.emplace_back(history_curve(results[label], label, "cube"));
    const Curve& energy = energies.curves.emplace_back(box_energy(results[label], label));
    evaluation.add(reported("energy gained over the gas' work, source kinematics, " + label,
                            energy.y.back(), "0", "half stress times summed strain is no energy"));
    evaluation.add(reported("mean distance from the model over its largest value, " + label,
                            distance(curve, summed.rigid, 30), "none", "0 to 30 ms"));
    lifts.push_back(
        box_lift(fmt::format("source kinematics, cells of {} mm", cell), curve.y.back(), summed));
  }
  panel.curves.push_back(history_curve(results["objective"], "objective", "cube"));
  energies.curves.push_back(box_energy(results["objective"], "objective"));
  lifts.push_back(
      box_lift("objective kinematics, cells of 10 mm", panel.curves.back().y.back(), stretches));
  evaluation.add(box_updates_agree(results, extent));
  evaluation.add(within("energy gained over the gas' work, objective",
                        energies.curves.back().y.back(), 0, 0.05,
                        "walls and perimeter do no work; the pressure at the end of a step works "
                        "in (4.40), first order in the step"));
  evaluation.add(lifts);
  panel.curves.push_back(model_curve(summed.rigid, "model, summed strain", Style::reference));
  panel.curves.push_back(model_curve(stretches.rigid, "model, stretches", Style::reference));
  panel.curves.push_back(model_curve(stretches.soft, "the same, cube not rigid", Style::limit));
  evaluation.draw("displacement", "Figure 4.19: the cube on the lid.", {panel, energies});
  evaluation.remarks = box_remarks(end(summed.rigid), end(stretches.rigid), extent);
  return evaluation;
}

}  // namespace

std::vector<Case> chapter_four() {
  return {{"net", "Cuboid on a net", "4.4.2, Tables 4.1 and 4.2, Figures 4.15 to 4.17",
           "a finite-deformation string with a block, computed by itself", net_runs, evaluate_net},
          {"gas_box", "Box of gas with a membrane and a cube",
           "4.4.3, Table 4.3, Figures 4.18 to 4.20; 5.3, Figure 5.9",
           "membrane with an adiabatic gas, computed by itself", box_runs, evaluate_box}};
}

}  // namespace zona::studies::verification
