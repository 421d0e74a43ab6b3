#include <fmt/format.h>

#include <cmath>

#include "studies/verification/cases/case_list.h"
#include "studies/verification/evaluation/curves.h"

namespace zona::studies::verification {

namespace {

// Constants of the bundled study files.
constexpr double modulus = 17.9e3, poisson = 0.49;  // of the zona, Table 5.2
constexpr double elastic_limit = 0.05937;           // S_L
constexpr double zona_yield = 1062.8;               // sigma_y of 5.4 [Pa]
constexpr double reference_opening = 1e-8;          // u_0 [m]

const std::vector<std::string> modes{"mode_1", "mode_2", "mode_mixed"};

std::vector<Run> point_runs(Extent) {
  std::vector<Run> runs;
  for (const char* name : {"uniaxial", "elastodamage", "mode_1", "mode_2", "mode_mixed", "zona"}) {
    runs.push_back({name, fmt::format("point_{}.toml", name), {}});
  }
  return runs;
}

/// Every tenth row of a history.
Curve path(const RunResults& run, const std::string& label, const std::string& column,
           double unit = 1) {
  const ResultTable history = run.table("history.csv");
  Curve curve{label};
  for (std::size_t i = 0; i < history.rows(); i += 10) {
    curve.add(history["strain_xx"][i], history[column][i] / unit);
  }
  return curve;
}

double number(const nlohmann::json& event, const char* name) {
  return event.at(name).get<double>();
}

std::vector<Check> solid_checks(const RunResults& run) {
  const auto& results = run.results();
  const std::string step = "half a step of the path, 2e-5 of strain";
  // The strength over the internal variable, which is sqrt(2/3) times the plastic strain's work.
  const double rise = 0.5 * (300e6 + 350e6) * 50e6 / 10e9, fall = 0.5 * 350e6 * 350e6 / 5e9;
  return {near("yield of a solid [Pa]", number(results.at("yield"), "equivalent_stress"), 300e6,
               1e-3, step),
          near("peak of a solid [Pa]", number(results.at("peak"), "equivalent_stress"), 350e6, 1e-3,
               step),
          near("plastic dissipation of a solid [J/m^3]", run.number("dissipated"),
               std::sqrt(2. / 3) * (rise + fall), 1e-3, "trapezoids over 2000 steps a segment"),
          at_most("stress left in free components [Pa]",
                  run.number("largest_stress_of_free_components"), 1e-5, "rounding of 350 MPa")};
}

std::vector<Check> damage_checks(const RunResults& run) {
  const auto& results = run.results();
  return {near("strain at which the zona begins to damage", results.at("yield").at("strain").at(0),
               elastic_limit, 1e-3, "half a step of the path"),
          near("strain at which the zona has failed, elastodamage",
               results.at("failure").at("strain").at(0), 0.06, 1e-3,
               "text below (5.11); (5.10) taken without its 2")};
}

std::vector<Check> mode_checks(const std::string& mode, const RunResults& run) {
  const auto& bifurcation = run.results().at("bifurcation");
  return {near("normal of the surface to the tension [deg], " + mode,
               number(bifurcation, "angle_to_largest_principal_stress") * 180 / M_PI,
               std::atan(std::sqrt(0.5)) * 180 / M_PI, 1e-3,
               "plane stress, one tension: tan^2 = 1/2, the classical band at 54.7 degrees"),
          near("energy of the opening [J/m^2], " + mode, run.number("opening_dissipation"),
               0.5 * reference_opening * number(bifurcation, "reference_traction"), 0.02,
               "u_0 tau_0/2, any mode (5.36); taken at fixed strain, first order in the step")};
}

/// Transverse over axial strain of the opening: a slide keeps the area.
double contraction(const RunResults& run) {
  const auto& start = run.results().at("bifurcation").at("strain");
  const auto& end = run.results().at("failure").at("strain");
  const double elastic = zona_yield / modulus;
  const double axial = end.at(0).get<double>() - start.at(0).get<double>() + elastic;
  const double transverse = end.at(1).get<double>() - start.at(1).get<double>() - poisson * elastic;
  return transverse / axial;
}

std::vector<Panel> point_panels(const CaseResults& results) {
  Panel solid{"solid", {"strain"}, {"stress [MPa]"}};
  solid.curves = {path(results["uniaxial"], "von Mises", "stress_xx", 1e6)};
  Panel membrane{"zona", {"strain"}, {"stress [Pa]"}};
  membrane.curves = {path(results["elastodamage"], "elastodamage", "stress_xx"),
                     path(results["zona"], "decohesion, 6 um", "stress_xx")};
  Panel opening{"zona, cells of 20 nm", {"strain"}, {"stress [Pa]"}};
  Panel slides{"the same", {"strain"}, {"transverse strain"}};
  for (const std::string& mode : modes) {
    opening.curves.push_back(path(results[mode], mode, "stress_xx"));
    slides.curves.push_back(path(results[mode], mode, "strain_yy"));
  }
  return {solid, membrane, opening, slides};
}

Evaluation evaluate_points(const CaseResults& results, Extent) {
  Evaluation evaluation;
  evaluation.add(solid_checks(results["uniaxial"]));
  evaluation.add(damage_checks(results["elastodamage"]));
  for (const std::string& mode : modes) evaluation.add(mode_checks(mode, results[mode]));
  const RunResults& zona = results["zona"];
  const double ratio = zona.number("opening_dissipation") / zona.number("resolved_opening_energy");
  evaluation.add(
      {near("transverse over axial strain of the slide, mode_2", contraction(results["mode_2"]), -1,
            0.05, "c_m = 0.1 leaves some opening, of order c_m^2"),
       reported("energy of the zona's surface in a cell of 6 um over u_0 tau_0/2", ratio, "1",
                "the stored energy of the cell exceeds what opening takes")});
  evaluation.draw({"paths", "Single points of the laws of 5.3 (Figures 5.7 and 5.10 to 5.12).",
                   point_panels(results)});
  evaluation.remarks = {
      fmt::format("With the source's u_0 of 1e-8 m the opening resolves in cells below 0.22 um "
                  "only. In its cells of 4 to 6 um a point fails in the step of its peak and "
                  "dissipates {:.0f} times u_0 tau_0/2: a criterion of strength. u_0, q, c_m and "
                  "the angle are without effect there.",
                  ratio),
      "The source's text calls c_m = 10 mode I; the formula below (5.40) prints the ratio upside "
      "down. Its angles of 44.8 and 45 degrees come from the three-dimensional formula with the "
      "third stress zero; in the plane stress of a membrane it is 35.3 degrees.",
      "(5.10) prints 2 c_0, with which the stiffness would vanish at a strain of 0.05967; c_0 "
      "alone gives 0.05999, the 0.06 of the text."};
  return evaluation;
}

}  // namespace

std::vector<Case> material_points() {
  return {{"material_points", "Single points of the laws", "5.3, (5.7) to (5.42), Table 5.2",
           "closed forms", point_runs, evaluate_points}};
}

}  // namespace zona::studies::verification
