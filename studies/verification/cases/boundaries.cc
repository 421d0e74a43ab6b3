#include <fmt/format.h>

#include <cmath>

#include "studies/references/absorbing_boundary.h"
#include "studies/verification/cases/case_list.h"
#include "studies/verification/evaluation/curves.h"

namespace zona::studies::verification {

namespace {

// ---- piston and water (Figure 5.13)

std::vector<Run> piston_runs(Extent) {
  const std::string file = "verification/piston.toml";
  return {
      {"absorbing", file, {}},
      {"free", file, {"boundary.x_high=\"free\"", "grid.high=[\"0.9 m\", \"10 mm\", \"10 mm\"]"}},
      {"whole-tube", "verification/piston_whole.toml", {}}};
}

Curve stress_curve(const RunResults& run, const std::string& label) {
  const ResultTable history = run.table("history.csv");
  return {label, history["time"] * 1e6, history["probe.p.stress_xx"] / 1e6};
}

/// Mean of a curve between two instants.
double mean(const Curve& curve, double from, double to) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (curve.x[i] < from || curve.x[i] > to) continue;
    sum += curve.y[i];
    ++count;
  }
  return sum / count;
}

double water_speed() {
  return std::sqrt(5 * 6.13e8 / 1000);
}

/// Stress at the interface of piston and water [MPa].
double piston_stress() {
  const double modulus = 2e7 * (1 - 0.2) / ((1 + 0.2) * (1 - 2 * 0.2));
  const double piston = 2000 * std::sqrt(modulus / 2000);
  const double water = 1000 * water_speed();
  return -10 * piston * water / (piston + water) / 1e6;
}

Evaluation evaluate_piston(const CaseResults& results, Extent) {
  Evaluation evaluation;
  const double exact = piston_stress();
  Panel panel{"", {"time [us]"}, {"stress [MPa]"}};
  for (const std::string label : {"absorbing", "whole-tube", "free"}) {
    panel.curves.push_back(stress_curve(results[label], label));
  }
  const auto& curves = panel.curves;
  for (const int i : {0, 1}) {
    evaluation.add(near("mean stress since the front's arrival [MPa], " + curves[i].label,
                        mean(curves[i], 57, 500), exact, 0.03,
                        "the soft piston spans few cells: the stress rings, its mean errs by the "
                        "last, incomplete period"));
  }
  evaluation.add(
      {at_most("difference of the means with and without the tube behind the face, over the stress",
               std::abs(mean(curves[0], 57, 500) - mean(curves[1], 57, 500)) / std::abs(exact),
               0.02, "what an absorbing face may send back"),
       reported("mean stress with a free face [MPa]", mean(curves[2], 300, 500), "0",
                "all of the wave comes back")});
  panel.curves.push_back({"exact", {0, 500}, {exact, exact}, Style::reference});
  evaluation.draw("stress", "Figure 5.13: stress at p.", {panel});
  evaluation.remarks = {
      "The piston's wave takes a third of a cell's crossing time of the water: at the source's "
      "resolution its stress rings by more than its mean, so the mean is held to the exact "
      "stress."};
  return evaluation;
}

// ---- oblique incidence

/// At 20 degrees little comes back: quick holds the formula at the others.
std::vector<int> angles(Extent extent) {
  return extent == Extent::quick ? std::vector<int>{0, 40, 60} : std::vector<int>{0, 20, 40, 60};
}

/// Where the crest crosses y = 0 at first [m]: far enough from the face that it has not met it
/// where the listener's reflection comes from, near enough that edges of the grid are not heard.
double start(int angle) {
  return angle < 50 ? 0.3 : -0.6;
}

std::string oblique_label(int angle, int cell) {
  return fmt::format("angle-{}-cell-{}mm", angle, cell);
}

std::vector<Run> oblique_runs(Extent extent) {
  std::vector<Run> runs;
  std::vector<std::pair<int, int>> resolutions;  // angle, cell [mm]
  for (const int angle : angles(extent)) resolutions.push_back({angle, 10});
  resolutions.push_back({0, 5});
  if (extent == Extent::full) resolutions.push_back({40, 5});
  for (const auto& [angle, cell] : resolutions) {
    const double c = std::cos(angle * M_PI / 180), s = std::sin(angle * M_PI / 180);
    // A plane pulse of 0.1 m/s, half width 60 mm; its acoustic pressure is rho c v.
    const std::string shape =
        fmt::format("exp(-(((x - {})*{:.9f} + y*{:.9f})/0.06)^2)", start(angle), c, s);
    runs.push_back(
        {oblique_label(angle, cell),
         "verification/oblique_wave.toml",
         {fmt::format("body.water.velocity=[\"{:.9f}*{}\", \"{:.9f}*{}\", \"0\"]", 0.1 * c, shape,
                      0.1 * s, shape),
          fmt::format("body.water.pressure=\"{:.9g}*{}\"", 0.1 * 1000 * water_speed(), shape),
          fmt::format("body.water.density=\"1000*(1 + {:.9g}*{})\"", 0.1 / water_speed(), shape),
          // Its reflection has met the face at y = 0.
          fmt::format("probe.listener.place=[\"0.7 m\", \"{:.9f} m\", \"5 mm\"]", 0.3 * s / c)}});
    const bool is_strip = angle == 0 && (cell == 5 || extent == Extent::quick);
    if (cell == 10 && !is_strip) continue;
    auto& overrides = runs.back().overrides;
    overrides.push_back(fmt::format("grid.cell=\"{} mm\"", cell));
    // Along the normal nothing changes across.
    overrides.push_back(
        fmt::format("grid.low=[\"-0.7 m\", \"{} m\", \"0 m\"]", is_strip ? 0 : -1.2));
    overrides.push_back(
        fmt::format("grid.high=[\"1 m\", \"{} m\", \"{} mm\"]", is_strip ? 0.001 * cell : 2, cell));
  }
  return runs;
}

/// Largest pressure of the reflection over that of the pulse, where the listener hears them.
double reflected_fraction(const RunResults& run, int angle) {
  const ResultTable history = run.table("history.csv");
  const auto& t = history["time"];
  const auto& p = history["probe.listener.pressure"];
  // The listener stands 0.3 m before the face; midway between the two crests it changes over.
  const double radians = angle * M_PI / 180;
  const double to_listener =
      (0.7 - start(angle)) * std::cos(radians) + 0.3 * std::tan(radians) * std::sin(radians);
  const double parting = (to_listener + 0.3 * std::cos(radians)) / water_speed();
  const double over = parting + 0.6 * std::cos(radians) / water_speed();  // before edges matter
  double incident = 0, reflected = 0;
  for (std::size_t i = 0; i < t.size() && t[i] < over; ++i) {
    double& largest = t[i] < parting ? incident : reflected;
    if (std::abs(p[i]) > std::abs(largest)) largest = p[i];
  }
  return std::abs(reflected / incident);
}

double exact_fraction(double degrees) {
  return -references::reflected_pressure(degrees * M_PI / 180);
}

Evaluation evaluate_oblique(const CaseResults& results, Extent extent) {
  Evaluation evaluation;
  Curve exact = exact_curve(75, 75, exact_fraction);
  exact.label = "(1 - cos)/(1 + cos)";
  Curve computed{"computed", {}, {}, Style::points};
  const auto fraction = [&](int angle, int cell) {
    return reflected_fraction(results[oblique_label(angle, cell)], angle);
  };
  for (const int angle : angles(extent)) {
    computed.add(angle, fraction(angle, 10));
    const std::string quantity = fmt::format("reflected fraction at {} degrees, cells of ", angle);
    if (angle > 0) {
      evaluation.add(within(quantity + "10 mm", computed.y.back(), exact_fraction(angle), 0.03,
                            "what comes back at 0 degrees from a pulse of 6 cells"));
      continue;
    }
    const double fine = fraction(0, 5);
    evaluation.add(
        {reported(quantity + "10 mm", computed.y.back(), fmt::format("{:.3g} with 5 mm", fine),
                  "tractions act at nodes, half a cell's mass beside the points'"),
         at_most(quantity + "5 mm", fine, 0.02, "a pulse of 12 cells half width")});
  }
  if (extent == Extent::full) {
    evaluation.add(within("reflected fraction at 40 degrees, cells of 5 mm", fraction(40, 5),
                          exact_fraction(40), 0.02, "as at 0 degrees"));
  }
  Panel panel{"", {"angle of incidence [degrees]"}, {"reflected over incident pressure"}};
  panel.curves = {exact, computed};
  evaluation.draw("reflection", "What an absorbing face sends back.", {panel});
  return evaluation;
}

}  // namespace

std::vector<Case> boundaries() {
  return {{"piston", "Piston and water", "5.4, Figures 5.12 and 5.13", "exact stress of the impact",
           piston_runs, evaluate_piston},
          {"oblique_wave", "Waves that meet an absorbing face obliquely", "(5.43)-(5.50)",
           "(1 - cos)/(1 + cos)", oblique_runs, evaluate_oblique}};
}

}  // namespace zona::studies::verification
