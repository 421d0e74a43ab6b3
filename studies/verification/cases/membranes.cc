#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/hencky_membrane.h"
#include "studies/references/inflated_sphere.h"
#include "studies/references/membrane_strip.h"
#include "studies/references/sheared_membrane.h"
#include "studies/verification/cases/case_list.h"

namespace zona::studies::verification {

namespace {

using references::MembraneLaw;

const MembraneLaw law{1e5, 0.3, 0.01, references::StrainMeasure::biot,
                      references::StressMeasure::kirchhoff};

/// The last value of a column of history.csv.
double last(const RunResults& run, const std::string& column) {
  return run.table("history.csv")[column].back();
}

/// Stretch between two probed points that start `distance` apart along an axis.
double stretch(const RunResults& run, const std::string& from, const std::string& to,
               const std::string& axis, double distance) {
  const auto displacement = [&](const std::string& probe) {
    return last(run, fmt::format("probe.{}.displacement_{}", probe, axis));
  };
  return 1 + (displacement(to) - displacement(from)) / distance;
}

// ---- strip

std::vector<Run> strip_runs(Extent) {
  const std::string file = "verification/membrane_strip.toml";
  return {{"taut", file, {}},
          {"both-ways", file, {"body.strip.one_way=\"off\""}},
          {"source-one-way", file, {"body.strip.one_way=\"strain\"", "time.end=\"0.9 s\""}},
          {"source-kinematics", file, {"body.strip.kinematics=\"source\""}},
          {"wrinkled", "verification/membrane_strip_wrinkled.toml", {}}};
}

Evaluation evaluate_strip(const CaseResults& results, Extent) {
  Evaluation evaluation;
  const std::string second_order =
      "strain of 2 %: measures of strain differ by half its square; what rests after damping";
  for (const std::string label : {"taut", "source-kinematics"}) {
    const RunResults& run = results[label];
    const double along = stretch(run, "left", "right", "x", 0.4);
    const auto strip = references::free_strip(law, along);
    evaluation.checks.push_back(near("stress of a free strip [Pa], " + label,
                                     last(run, "probe.middle.stress_xx"), strip.stress, 0.02,
                                     second_order));
    evaluation.checks.push_back(within("lateral over axial stress, " + label,
                                       last(run, "probe.middle.stress_yy") / strip.stress, 0, 0.02,
                                       second_order));
    evaluation.checks.push_back(at_least(
        "lateral contraction over elongation, " + label,
        (1 - stretch(run, "below", "above", "y", 0.2)) / (along - 1), 0.95 * law.poisson_ratio,
        "Poisson's ratio; nothing holds a free edge that wrinkles let come closer"));
  }
  const RunResults& both = results["both-ways"];
  evaluation.checks.push_back(near("lateral contraction over elongation, carrying compression",
                                   (1 - stretch(both, "below", "above", "y", 0.2)) /
                                       (stretch(both, "left", "right", "x", 0.4) - 1),
                                   law.poisson_ratio, 0.05, second_order));
  const RunResults& source = results["source-one-way"];
  const double along = stretch(source, "left", "right", "x", 0.4);
  evaluation.checks.push_back(
      near("stress of a free strip over E e with the source's one-way law",
           last(source, "probe.middle.stress_xx") / (law.youngs_modulus * (along - 1)),
           1 / (1 - law.poisson_ratio * law.poisson_ratio), 0.05,
           "while it is pulled, at 0.9 s: not yet at rest"));
  evaluation.checks.push_back(
      reported("its lateral contraction over its elongation",
               (1 - stretch(source, "below", "above", "y", 0.2)) / (along - 1), "0.3",
               "grows without end: the law pulls a strip together with nu times its stress"));
  const RunResults& wrinkled = results["wrinkled"];
  const double stretched = stretch(wrinkled, "left", "right", "x", 0.4);
  evaluation.checks.push_back(
      near("stress of a wrinkled strip [Pa]", last(wrinkled, "probe.middle.stress_xx"),
           references::free_strip(law, stretched).stress, 0.02, second_order));
  evaluation.checks.push_back(
      within("stress across the wrinkles over that along them",
             last(wrinkled, "probe.middle.stress_yy") / last(wrinkled, "probe.middle.stress_xx"), 0,
             0.01, second_order));
  evaluation.remarks = {
      "The source zeroes negative principal *strains*: a strip under uniaxial stress, whose "
      "lateral "
      "strain is negative, then carries 1/(1 - nu^2) of its stress. The default tells taut, "
      "wrinkled and slack apart by the principal stresses."};
  return evaluation;
}

// ---- shear

std::vector<Run> shear_runs(Extent) {
  const std::string file = "verification/membrane_shear.toml";
  return {{"wrinkled", file, {}}, {"both-ways", file, {"body.sheet.one_way=\"off\""}}};
}

Evaluation evaluate_shear(const CaseResults& results, Extent) {
  Evaluation evaluation;
  const double gamma = 0.02;
  const auto field = references::finitely_sheared(law, 1, gamma);
  MembraneLaw both_ways = law;
  both_ways.wrinkling = references::Wrinkling::none;
  const auto two_way = references::finitely_sheared(both_ways, 1, gamma);
  const double scale = law.youngs_modulus * gamma / 4;
  const std::string origin =
      "what rests after damping; the grid's nodes hold the shear exactly around the sheet";
  const auto check = [&](const std::string& label, const std::string& component, double reference) {
    evaluation.checks.push_back(
        within(fmt::format("stress {} over E gamma/4, {}", component, label),
               last(results[label], "probe.middle.stress_" + component) / scale, reference / scale,
               0.02, origin));
  };
  check("wrinkled", "xx", field.xx);
  check("wrinkled", "yy", field.yy);
  check("wrinkled", "xy", field.xy);
  check("both-ways", "xx", two_way.xx);
  check("both-ways", "yy", two_way.yy);
  check("both-ways", "xy", two_way.xy);
  return evaluation;
}

// ---- sphere

std::vector<Run> sphere_runs(Extent extent) {
  const std::string file = "verification/inflated_sphere.toml";
  std::vector<Run> runs{{"cell-0.5", file, {"grid.cell=\"0.5 m\""}},
                        {"cell-0.25", file, {}},
                        {"linear", file, {"grid.interpolation=\"linear\""}},
                        {"source-kinematics", file, {"body.balloon.kinematics=\"source\""}}};
  if (extent == Extent::full) {
    runs.push_back({"cell-0.125", file, {"grid.cell=\"0.125 m\"", "body.balloon.level=5"}});
  }
  return runs;
}

double mean_stretch(const RunResults& run) {
  const double pole = last(run, "probe.pole.displacement_z");
  const double slant = std::sqrt(3.) * last(run, "probe.slant.displacement_x");
  return 1 + (pole + slant) / 2;
}

Evaluation evaluate_sphere(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const double exact = references::sphere_stretch(law, 1, 120);
  const auto error = [&](const std::string& label) {
    return std::abs(mean_stretch(results[label]) - exact) / (exact - 1);
  };
  evaluation.checks.push_back(
      near("growth of the radius, cells of R/4", mean_stretch(results["cell-0.25"]) - 1, exact - 1,
           0.05, "a membrane in cells of R/4: second order in the cell, (1/4)^2 and less"));
  evaluation.checks.push_back(
      near("growth of the radius, the source's kinematics",
           mean_stretch(results["source-kinematics"]) - 1, exact - 1, 0.05,
           "the same; strains of some percent: measures differ by half their square"));
  std::vector<double> cells{0.5, 0.25};
  std::vector<double> errors{error("cell-0.5"), error("cell-0.25")};
  if (extent == Extent::full) {
    cells.push_back(0.125);
    errors.push_back(error("cell-0.125"));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    evaluation.checks.push_back(
        reported(fmt::format("error of the growth, cells of {:g} R", cells[i]), errors[i], "0",
                 "the largest part is what the pressure and the membrane lose in the cells"));
  }
  for (const std::string label : {"cell-0.25", "linear"}) {
    const RunResults& run = results[label];
    evaluation.checks.push_back(
        reported("kinetic over stored energy at the end, " + label,
                 last(run, "kinetic_energy") / last(run, "stored_energy"), "0",
                 "at rest it is zero; with linear functions noise of the points "
                 "grows"));
  }
  evaluation.remarks = {
      "With linear shape functions the points of a free membrane, many in a cell, pick up noise "
      "that "
      "the grid does not see and that no damping of the grid removes; quadratic B-splines keep it "
      "away. Beside a fluid, which fills the cells, linear functions do."};
  return evaluation;
}

// ---- Hencky

std::vector<Run> hencky_runs(Extent extent) {
  const std::string file = "verification/hencky.toml";
  std::vector<Run> runs{{"cell-0.1", file, {}},
                        {"cell-0.05", file, {"grid.cell=\"0.05 m\"", "body.membrane.rings=44"}}};
  if (extent == Extent::full) {
    runs.push_back({"cell-0.025", file, {"grid.cell=\"0.025 m\"", "body.membrane.rings=88"}});
  }
  return runs;
}

Evaluation evaluate_hencky(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  const references::HenckyMembrane exact({1, 0.01, 1e5, 0.3, 4});
  std::vector<double> cells{0.1, 0.05};
  if (extent == Extent::full) cells.push_back(0.025);
  std::vector<double> errors;
  for (const double cell : cells) {
    const RunResults& run = results[fmt::format("cell-{}", cell)];
    const double deflection = last(run, "probe.centre.displacement_z");
    errors.push_back(std::abs(deflection / exact.deflection(0) - 1));
    evaluation.checks.push_back(near(
        fmt::format("deflection of the centre [m], cells of a/{:.0f}", 1 / cell), deflection,
        exact.deflection(0), 2 * cell,
        "the clamp holds whole cells: the radius is uncertain by one, the deflection by 4/3 of "
        "that"));
    if (cell != cells.back()) continue;
    evaluation.checks.push_back(near(
        "stress at the centre [Pa]", last(run, "probe.centre.stress_xx"),
        exact.radial_tension(0) / law.thickness, 4 * cell, "a single point in cells of this size"));
  }
  evaluation.checks.push_back(
      converges("the deflection", cells, errors, 0.7, "first, from the place of the clamp"));
  return evaluation;
}

// ---- bending

std::vector<Run> bending_runs(Extent) {
  return {{"bent", "verification/membrane_bending.toml", {}}};
}

Evaluation evaluate_bending(const CaseResults& results, Extent) {
  Evaluation evaluation;
  const RunResults& run = results["bent"];
  const ResultTable section = run.table("profiles.csv");
  const auto& y = section["slice"];
  const auto& stress = section["stress_xx"];
  double force = 0, moment = 0, peak = 0, band = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double strip_width = 0.05;
    force += stress[i] * 0.01 * strip_width;
    moment += stress[i] * 0.01 * strip_width * (0.5 - y[i]);
    peak = std::max(peak, stress[i]);
  }
  moment = std::abs(moment);
  for (const double s : stress) band += s < 0.02 * peak ? 0.05 : 0;
  const double lower = stretch(run, "lower_left", "lower_right", "x", 0.6);
  const double upper = stretch(run, "upper_left", "upper_right", "x", 0.6);
  const double curvature = std::abs(upper - lower) / 0.9;
  const references::BentStrip strip{1e5, 0.01, 1, force};
  const double exact_moment = references::bent_strip_moment(strip, curvature);
  const auto exact = references::bent_strip(strip, exact_moment);
  const std::string origin =
      "an edge layer of one cell, 1/20 of the height, carries a quarter of the moment; where the "
      "edge "
      "is, the cell does not know";
  evaluation.checks.push_back(reported("moment over tension and height", moment / force,
                                       "1/6 wrinkles, 1/2 collapses", "of the mid-section"));
  evaluation.checks.push_back(
      near("moment at this curvature [N m]", moment, exact_moment, 0.125, origin));
  evaluation.checks.push_back(
      within("height of the wrinkled band [m]", band, exact.band, 0.05, "slices of 0.05"));
  evaluation.checks.push_back(reported("largest stress of a slice [Pa]", peak,
                                       fmt::format("{:.4g} at the edge", exact.largest_stress),
                                       "the outermost slice lies half of its 0.05 from the edge"));
  Curve computed{"computed", {}, {}, Style::points},
      reference{"Stein and Hedgepeth", {}, {}, Style::reference};
  const bool lower_tense = lower > upper;
  for (std::size_t i = 0; i < y.size(); ++i) {
    computed.x.push_back(y[i]);
    computed.y.push_back(stress[i]);
    const double from_tense = lower_tense ? y[i] : 1 - y[i];
    reference.x.push_back(y[i]);
    reference.y.push_back(std::max(0., exact.largest_stress * (1 - from_tense / (1 - exact.band))));
  }
  evaluation.figures.push_back({"section",
                                "Stress across the mid-section of the bent strip.",
                                {{"", {"height [m]"}, {"stress [Pa]"}, {reference, computed}}},
                                {}});
  return evaluation;
}

}  // namespace

Case membrane_strip() {
  return {"membrane_strip",
          "Strip of membrane: taut and wrinkled",
          "",
          "uniaxial stress; the tension-field law",
          strip_runs,
          evaluate_strip};
}

Case membrane_shear() {
  return {"membrane_shear",
          "Membrane in pure shear",
          "",
          "tension field E gamma/4; G gamma without wrinkles",
          shear_runs,
          evaluate_shear};
}

Case inflated_sphere() {
  return {
      "inflated_sphere", "Inflated spherical membrane", "", "closed form, Biot strain", sphere_runs,
      evaluate_sphere};
}

Case hencky() {
  return {"hencky",    "Clamped circular membrane under pressure",
          "",          "Hencky's series",
          hencky_runs, evaluate_hencky};
}

Case membrane_bending() {
  return {"membrane_bending",
          "Pretensioned membrane bent in its plane",
          "",
          "Stein and Hedgepeth 1961",
          bending_runs,
          evaluate_bending};
}

}  // namespace zona::studies::verification
