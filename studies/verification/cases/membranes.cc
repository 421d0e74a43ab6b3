#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/hencky_membrane.h"
#include "studies/references/inflated_sphere.h"
#include "studies/references/membrane_strip.h"
#include "studies/references/sheared_membrane.h"
#include "studies/verification/cases/case_list.h"
#include "studies/verification/evaluation/curves.h"

namespace zona::studies::verification {

namespace {

using references::MembraneLaw;

const MembraneLaw law{1e5, 0.3, 0.01, references::StrainMeasure::biot,
                      references::StressMeasure::kirchhoff};

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

const char* const second_order =
    "strain of 2 %: measures of strain differ by half its square; what rests after damping";

/// A strip at the end of its run.
struct Strip {
  const RunResults& run;
  double along = stretch(run, "left", "right", "x", 0.4);
  double stress = last(run, "probe.middle.stress_xx");          // [Pa]
  double lateral_stress = last(run, "probe.middle.stress_yy");  // [Pa]
  double exact_stress = references::free_strip(law, along).stress;

  /// Of the width, over the elongation.
  double contraction() const {
    return (1 - stretch(run, "below", "above", "y", 0.2)) / (along - 1);
  }
};

Evaluation evaluate_strip(const CaseResults& results, Extent) {
  Evaluation evaluation;
  for (const std::string label : {"taut", "source-kinematics"}) {
    const Strip strip{results[label]};
    evaluation.add(
        {near("stress of a free strip [Pa], " + label, strip.stress, strip.exact_stress, 0.02,
              second_order),
         within("lateral over axial stress, " + label, strip.lateral_stress / strip.exact_stress, 0,
                0.02, second_order),
         at_least("lateral contraction over elongation, " + label, strip.contraction(),
                  0.95 * law.poisson_ratio,
                  "Poisson's ratio; nothing holds a free edge that wrinkles let come closer")});
  }
  const Strip source{results["source-one-way"]}, wrinkled{results["wrinkled"]};
  evaluation.add(
      {near("lateral contraction over elongation, carrying compression",
            Strip{results["both-ways"]}.contraction(), law.poisson_ratio, 0.05, second_order),
       near("stress of a free strip over E e with the source's one-way law",
            source.stress / (law.youngs_modulus * (source.along - 1)),
            1 / (1 - law.poisson_ratio * law.poisson_ratio), 0.05,
            "while it is pulled, at 0.9 s: not yet at rest"),
       reported("its lateral contraction over its elongation", source.contraction(), "0.3",
                "grows without end: the law pulls a strip together with nu times its stress"),
       near("stress of a wrinkled strip [Pa]", wrinkled.stress, wrinkled.exact_stress, 0.02,
            second_order),
       within("stress across the wrinkles over that along them",
              wrinkled.lateral_stress / wrinkled.stress, 0, 0.01, second_order)});
  evaluation.remarks = {
      "The source zeroes negative principal *strains*: a strip under uniaxial stress, whose "
      "lateral strain is negative, then carries 1/(1 - nu^2) of its stress. The default tells "
      "taut, wrinkled and slack apart by the principal stresses."};
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
  const double scale = law.youngs_modulus * gamma / 4;
  MembraneLaw both_ways = law;
  both_ways.wrinkling = references::Wrinkling::none;
  for (const auto& [label, of] : {std::pair{"wrinkled", law}, std::pair{"both-ways", both_ways}}) {
    const auto exact = references::finitely_sheared(of, 1, gamma);
    for (const auto& [component, stress] :
         {std::pair{"xx", exact.xx}, std::pair{"yy", exact.yy}, std::pair{"xy", exact.xy}}) {
      evaluation.add(within(
          fmt::format("stress {} over E gamma/4, {}", component, label),
          last(results[label], std::string("probe.middle.stress_") + component) / scale,
          stress / scale, 0.02,
          "what rests after damping; the grid's nodes hold the shear exactly around the sheet"));
    }
  }
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
  const auto stretch = [&](const std::string& label) { return mean_stretch(results[label]); };
  evaluation.add(
      {near("growth of the radius, cells of R/4", stretch("cell-0.25") - 1, exact - 1, 0.05,
            "a membrane in cells of R/4: second order in the cell, (1/4)^2 and less"),
       near("growth of the radius, the source's kinematics", stretch("source-kinematics") - 1,
            exact - 1, 0.05,
            "the same; strains of some percent: measures differ by half their square")});
  for (const double cell : of_extent(extent, {0.5, 0.25}, {0.125})) {
    evaluation.add(
        reported(fmt::format("error of the growth, cells of {:g} R", cell),
                 std::abs(stretch(fmt::format("cell-{:g}", cell)) - exact) / (exact - 1), "0",
                 "the largest part is what the pressure and the membrane lose in the cells"));
  }
  for (const std::string label : {"cell-0.25", "linear"}) {
    const RunResults& run = results[label];
    evaluation.add(reported("kinetic over stored energy at the end, " + label,
                            last(run, "kinetic_energy") / last(run, "stored_energy"), "0",
                            "at rest it is zero; with linear functions noise of the points grows"));
  }
  evaluation.remarks = {
      "With linear shape functions the points of a free membrane, many in a cell, pick up noise "
      "that the grid does not see and that no damping of the grid removes; quadratic B-splines "
      "keep it away. Beside a fluid, which fills the cells, linear functions do."};
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
  Curve errors;
  for (const double cell : of_extent(extent, {0.1, 0.05}, {0.025})) {
    const double deflection =
        last(results[fmt::format("cell-{}", cell)], "probe.centre.displacement_z");
    errors.add(cell, std::abs(deflection / exact.deflection(0) - 1));
    evaluation.add(near(fmt::format("deflection of the centre [m], cells of a/{:.0f}", 1 / cell),
                        deflection, exact.deflection(0), 2 * cell,
                        "the clamp holds whole cells: the radius is uncertain by one, the "
                        "deflection by 4/3 of that"));
  }
  const double finest = errors.x.back();
  evaluation.add(
      {near("stress at the centre [Pa]",
            last(results[fmt::format("cell-{}", finest)], "probe.centre.stress_xx"),
            exact.radial_tension(0) / law.thickness, 4 * finest,
            "a single point in cells of this size"),
       converges("the deflection", errors.x, errors.y, 0.7, "first, from the place of the clamp")});
  return evaluation;
}

// ---- bending

std::vector<Run> bending_runs(Extent) {
  return {{"bent", "verification/membrane_bending.toml", {}}};
}

/// What the slices of 0.05 m across the mid-section carry.
struct BentSection {
  double force = 0, moment = 0, peak = 0, band = 0;  // [N], [N m], [Pa], [m]

  BentSection(const std::vector<double>& y, const std::vector<double>& stress) {
    const double strip_width = 0.05;
    for (std::size_t i = 0; i < y.size(); ++i) {
      force += stress[i] * 0.01 * strip_width;
      moment += stress[i] * 0.01 * strip_width * (0.5 - y[i]);
      peak = std::max(peak, stress[i]);
    }
    moment = std::abs(moment);
    for (const double s : stress) band += s < 0.02 * peak ? 0.05 : 0;
  }
};

Evaluation evaluate_bending(const CaseResults& results, Extent) {
  Evaluation evaluation;
  const RunResults& run = results["bent"];
  const ResultTable table = run.table("profiles.csv");
  const BentSection section(table["slice"], table["stress_xx"]);
  const double lower = stretch(run, "lower_left", "lower_right", "x", 0.6);
  const double upper = stretch(run, "upper_left", "upper_right", "x", 0.6);
  const references::BentStrip strip{1e5, 0.01, 1, section.force};
  const double moment = references::bent_strip_moment(strip, std::abs(upper - lower) / 0.9);
  const auto exact = references::bent_strip(strip, moment);
  evaluation.add(
      {reported("moment over tension and height", section.moment / section.force,
                "1/6 wrinkles, 1/2 collapses", "of the mid-section"),
       near("moment at this curvature [N m]", section.moment, moment, 0.125,
            "an edge layer of one cell, 1/20 of the height, carries a quarter of the moment; the "
            "grid "
            "does not resolve where the edge lies"),
       within("height of the wrinkled band [m]", section.band, exact.band, 0.05, "slices of 0.05"),
       reported("largest stress of a slice [Pa]", section.peak,
                fmt::format("{:.4g} at the edge", exact.largest_stress),
                "the outermost slice lies half of its 0.05 from the edge")});
  Curve reference{"Stein and Hedgepeth", {}, {}, Style::reference};
  for (const double y : table["slice"]) {
    const double from_tense = lower > upper ? y : 1 - y;
    reference.add(y, std::max(0., exact.largest_stress * (1 - from_tense / (1 - exact.band))));
  }
  Panel panel{"", {"height [m]"}, {"stress [Pa]"}, {reference}};
  panel.curves.push_back({"computed", table["slice"], table["stress_xx"], Style::points});
  evaluation.draw("section", "Stress across the mid-section of the bent strip.", {panel});
  return evaluation;
}

}  // namespace

std::vector<Case> membranes() {
  return {{"membrane_strip", "Strip of membrane: taut and wrinkled", "",
           "uniaxial stress; the tension-field law", strip_runs, evaluate_strip},
          {"membrane_shear", "Membrane in pure shear", "",
           "tension field E gamma/4; G gamma without wrinkles", shear_runs, evaluate_shear},
          {"inflated_sphere", "Inflated spherical membrane", "", "closed form, Biot strain",
           sphere_runs, evaluate_sphere},
          {"hencky", "Clamped circular membrane under pressure", "", "Hencky's series", hencky_runs,
           evaluate_hencky},
          {"membrane_bending", "Pretensioned membrane bent in its plane", "",
           "Stein and Hedgepeth 1961", bending_runs, evaluate_bending}};
}

}  // namespace zona::studies::verification
