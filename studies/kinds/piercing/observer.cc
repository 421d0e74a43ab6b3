#include "studies/kinds/piercing/observer.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "studies/kinds/piercing/decohesion_results.h"
#include "studies/kinds/piercing/failure_pattern.h"

namespace zona::studies {

PiercingObserver::PiercingObserver(const PiercingCase& piercing, const mpm::Solver& solver,
                                   spdlog::logger& log)
    : case_(piercing),
      solver_(solver),
      log_(log),
      meter_(solver.body("zona"), piercing_geometry(piercing.setup).tip) {}

std::vector<ValueColumn<>> PiercingObserver::columns() {
  std::vector<ValueColumn<>> columns{{"time", "s", [this] { return solver_.time(); }}};
  add_vector(columns, "pipette_", "m", [this] { return tip_.displacement; });
  add_vector(columns, "pipette_v", "m/s", [this] { return tip_.velocity; });
  add_vector(columns, "force_", "N", [this] { return pipette().reaction; });
  columns.insert(columns.end(),
                 {{"pipette_work", "J", [this] { return pipette_work_; }},
                  {"failed_points", "", [this] { return damage_.failed_points; }},
                  {"failed_area", "m^2", [this] { return damage_.failed_area; }},
                  {"largest_strain", "", [this] { return damage_.largest_strain; }},
                  {"strain_away", "", [this] { return damage_.strain_away; }},
                  {"largest_displacement", "m", [this] { return damage_.largest_displacement; }},
                  {"cytoplasm_pressure_low", "Pa", [this] { return pressure_.lowest; }},
                  {"cytoplasm_pressure_high", "Pa", [this] { return pressure_.highest; }},
                  {"cytoplasm_shear_rate", "1/s", [this] { return shear_rate_; }},
                  {"indentation", "m", [this] { return damage_.indentation; }},
                  {"mass", "kg", [this] { return totals_.mass; }}});
  add_vector(columns, "momentum_", "kg m/s", [this] { return totals_.momentum; });
  columns.push_back({"kinetic_energy", "J", [this] { return totals_.kinetic_energy; }});
  columns.push_back({"stored_energy", "J", [this] { return totals_.stored_energy; }});
  add_vector(columns, "plate_force_", "N", [this] { return plate_force(); });
  return columns;
}

const mpm::Prescribed& PiercingObserver::pipette() const {
  return *solver_.body("pipette").prescribed();
}

Eigen::Vector3d PiercingObserver::plate_force() const {
  for (const mpm::Body& body : solver_.bodies()) {
    if (body.name == "plate") return body.prescribed()->reaction;
  }
  return Eigen::Vector3d::Zero();
}

void PiercingObserver::after_step() {
  const mpm::Prescribed& moved = pipette();
  pipette_work_ += moved.reaction.dot(moved.next.velocity) * solver_.step_size();
  largest_force_ = std::max(largest_force_, moved.reaction.norm());
  if (damage_.failed_points > 0)
    path_after_failure_ += moved.next.velocity.norm() * solver_.step_size();
}

void PiercingObserver::measure() {
  const bool was_whole = damage_.failed_points == 0;
  damage_ = meter_.measure(solver_.body("zona"));
  if (was_whole && damage_.failed_points > 0) {
    log_.info("the zona begins to fail before {:.4g} us", solver_.time() * 1e6);
  }
  tip_ = pipette().state(std::min(solver_.time(), case_.end));
  pressure_ = mpm::cell_averaged_pressure(solver_.body("cytoplasm"));
  shear_rate_ = mpm::cell_averaged_shear_rate(solver_.body("cytoplasm"));
  totals_ = mpm::totals(solver_.bodies());
  highest_pressure_ = std::max(highest_pressure_, pressure_.highest);
  highest_shear_rate_ = std::max(highest_shear_rate_, shear_rate_);
  deepest_indentation_ = std::max(deepest_indentation_, damage_.indentation);
  largest_excursion_ = std::max(largest_excursion_, tip_.displacement.norm());
}

void PiercingObserver::visit_state(mpm::StateVisitor& visitor) {
  meter_.visit_state(visitor);
  damage_.visit_state(visitor);
  visitor.visit("pipette/impulse_work", pipette_work_);
  visitor.visit("pipette/largest_force", largest_force_);
  visitor.visit("pipette/largest_excursion", largest_excursion_);
  visitor.visit("cytoplasm/highest_pressure", highest_pressure_);
  visitor.visit("cytoplasm/highest_shear_rate", highest_shear_rate_);
  visitor.visit("zona/deepest_indentation", deepest_indentation_);
  visitor.visit("pipette/path_after_failure", path_after_failure_);
}

std::string PiercingObserver::status() const {
  return fmt::format("{} of {} points failed, strain {:.3f}", damage_.failed_points,
                     solver_.body("zona").points.size(), damage_.largest_strain);
}

void PiercingObserver::add_results(nlohmann::json& results) const {
  results["fluid"] = case_.fluid.name;
  results["fluid_density"] = case_.fluid.density;
  if (case_.tip_history) add_tip_results(results);
  add_zona_results(results);
  results["largest_excursion"] = largest_excursion_;
  results["highest_cytoplasm_pressure"] = highest_pressure_;
  results["highest_cytoplasm_shear_rate"] = highest_shear_rate_;
  results["path_after_failure"] = path_after_failure_;
  results["largest_pipette_force"] = largest_force_;
  results["pipette_work"] = pipette_work_;
  if (const mpm::ImplicitPressure* pressure = solver_.implicit_pressure())
    results["pressure_iterations"] = pressure->mean_iterations();
  results["time_step"] = case_.step;
  results["critical_time_step"] = case_.critical_step;
}

void PiercingObserver::add_tip_results(nlohmann::json& results) const {
  double amplitude = 0;
  for (double u : case_.tip_history->displacement) amplitude = std::max(amplitude, std::abs(u));
  results["tip_amplitude"] = amplitude;
  results["window_start"] = case_.window_start;
  if (case_.axial_tip_history) {
    const std::vector<double>& axial = case_.axial_tip_history->displacement;
    results["axial_tip_amplitude"] = std::abs(axial[beam::index_of_peak(axial)]);
  }
  if (!case_.bath_warnings.empty()) results["warnings"] = case_.bath_warnings;
  results["initial_speed"] = case_.setup.pipette.motion(0).velocity.norm();
}

void PiercingObserver::add_zona_results(nlohmann::json& results) const {
  const mpm::Membrane& zona = *solver_.body("zona").membrane();
  double first_failure = std::numeric_limits<double>::infinity();
  for (double t : zona.integrity.failure_time) first_failure = std::min(first_failure, t);
  results["failed_points"] = zona.failed_points;
  results["failed_area"] = damage_.failed_area;
  // Diameter of a round hole with the failed area.
  const double hole_diameter = std::sqrt(4 * damage_.failed_area / M_PI);
  results["hole_diameter"] = hole_diameter;
  results["hole_over_pipette"] = hole_diameter / case_.setup.pipette.outer_diameter;
  results["failure_pattern"] =
      to_json(failure_pattern(zona, meter_.reference(), piercing_geometry(case_.setup).tip));
  results["time_of_first_failure"] =
      std::isfinite(first_failure) ? nlohmann::json(first_failure) : nlohmann::json();
  if (const auto* plastic = std::get_if<mpm::MembraneState<mpm::VonMises>>(&zona.state)) {
    results["decohesion"] = decohesion_results(*plastic);
  }
  results["largest_strain_away"] = meter_.peak_strain_away();
  results["largest_displacement_away"] = meter_.peak_displacement_away();
  results["deepest_indentation"] = deepest_indentation_;
}

}  // namespace zona::studies
