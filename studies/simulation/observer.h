#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "mpm/points/state_visitor.h"
#include "studies/run/columns.h"

namespace zona::studies {

/// Follows a simulation for a kind of study, in addition to what every `Simulation` writes. All
/// calls come from one thread.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Columns of history.csv, without probes. The functions must stay valid as long as the observer;
  /// they are called after `measure`.
  virtual std::vector<ValueColumn<>> columns() = 0;
  /// Before each row of the history: measures what its columns show.
  virtual void measure() = 0;
  /// After each step, before a row is sampled.
  virtual void after_step() = 0;
  /// Shows what this object has accumulated over the steps.
  virtual void visit_state(mpm::StateVisitor& visitor) = 0;
  /// Quantities that the user watches while the simulation runs.
  virtual std::string status() const = 0;
  /// Adds to the results of the run.
  virtual void add_results(nlohmann::json& results) const = 0;
};

}  // namespace zona::studies
