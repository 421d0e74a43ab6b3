#pragma once

#include "mpm/results/diagnostics.h"
#include "mpm/step/solver.h"
#include "studies/input/configuration.h"
#include "studies/parameters/time_step.h"
#include "studies/simulation/observer.h"

namespace zona::studies {

/// Follows a scene: totals of all bodies and of each, forces and work of rigid bodies and holds.
/// Configuration and solver must outlive it.
class SceneObserver : public Observer {
 public:
  SceneObserver(const Configuration& study, const TimeStep& step, const mpm::Solver& solver,
                const Eigen::Vector3d& gravity);

  std::vector<ValueColumn<>> columns() override;
  void measure() override;
  void after_step() override;
  void visit_state(mpm::StateVisitor& visitor) override;
  std::string status() const override;
  void add_results(nlohmann::json& results) const override;

 private:
  /// Force that something exerts on the points around it, and its work since the start.
  struct Effort {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< in the last step [N]
    double work = 0;                                  ///< [J]

    void add(const Eigen::Vector3d& reaction, double power, double dt);
    void visit_state(const std::string& name, mpm::StateVisitor& visitor);
    void add_columns(std::vector<ValueColumn<>>& columns, const std::string& prefix) const;
  };

  void add_body_columns(std::vector<ValueColumn<>>& columns, std::size_t b) const;
  nlohmann::json body_results(std::size_t b) const;

  const Configuration& study_;
  TimeStep step_;
  const mpm::Solver& solver_;
  Eigen::Vector3d gravity_;

  // Measured for the row that is sampled.
  std::vector<mpm::BodyTotals> totals_;  ///< of each body
  mpm::BodyTotals sum_;
  double potential_energy_ = 0;  ///< [J]

  std::vector<Effort> rigid_;  ///< of each body; only rigid ones act
  std::vector<Effort> held_;
  double kinetic_energy_ = 0;  ///< of the last sample [J]
};

}  // namespace zona::studies
