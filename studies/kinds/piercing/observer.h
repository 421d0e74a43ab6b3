#pragma once

#include <spdlog/fwd.h>

#include "mpm/results/diagnostics.h"
#include "mpm/step/solver.h"
#include "studies/kinds/piercing/case.h"
#include "studies/kinds/piercing/damage.h"
#include "studies/simulation/observer.h"

namespace zona::studies {

/// Follows a piercing: motion and force of the pipette, damage of the zona, pressure and shear rate
/// of the cytoplasm. The case and the solver must outlive it.
class PiercingObserver : public Observer {
 public:
  PiercingObserver(const PiercingCase& piercing, const mpm::Solver& solver, spdlog::logger& log);

  std::vector<ValueColumn<>> columns() override;
  void measure() override;
  void after_step() override;
  void visit_state(mpm::StateVisitor& visitor) override;
  std::string status() const override;
  void add_results(nlohmann::json& results) const override;

 private:
  const mpm::Prescribed& pipette() const;
  /// Force of the plate on its surroundings in the last step; zero where there is no plate [N].
  Eigen::Vector3d plate_force() const;
  void add_tip_results(nlohmann::json& results) const;
  void add_zona_results(nlohmann::json& results) const;

  const PiercingCase& case_;
  const mpm::Solver& solver_;
  spdlog::logger& log_;
  DamageMeter meter_;

  // Measured for the row that is sampled.
  mpm::RigidState tip_;
  ZonaDamage damage_;
  mpm::PressureRange pressure_{};  ///< of the cytoplasm [Pa]
  double shear_rate_ = 0;          ///< of the cytoplasm [1/s]
  mpm::BodyTotals totals_;

  // Accumulated over steps and samples.
  double pipette_work_ = 0;         ///< on its surroundings [J]
  double largest_force_ = 0;        ///< of the pipette [N]
  double largest_excursion_ = 0;    ///< of the tip from its place at the start [m]
  double path_after_failure_ = 0;   ///< of the tip, from the sample that saw the first failure [m]
  double highest_pressure_ = 0;     ///< [Pa]
  double highest_shear_rate_ = 0;   ///< [1/s]
  double deepest_indentation_ = 0;  ///< [m]
};

}  // namespace zona::studies
