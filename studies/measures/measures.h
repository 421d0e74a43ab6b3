#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "studies/measures/probe.h"
#include "studies/measures/profiles.h"

namespace zona::studies {

/// Probes, profiles and sections of a simulation, as the tables [[probe]], [[profile]] and
/// [[section]] of its study describe them. Costs nothing where there are none.
class Measures {
 public:
  /// Make it before the first step. Places in the tables count from `origin` [m]; the run lasts
  /// until `end` [s]. The solver must outlive this object.
  Measures(const Configuration& study, const mpm::Solver& solver, const Eigen::Vector3d& origin,
           double end, const std::filesystem::path& directory, bool is_resumed);
  Measures(const Measures&) = delete;
  Measures& operator=(const Measures&) = delete;

  /// Adds the columns of all probes in history.csv, with the values of the last `sample`. They
  /// refer to this object.
  void add_columns(std::vector<ValueColumn<>>& columns) const;
  /// Measures at all probes.
  void sample();
  /// Writes profiles and sections that are due; call it at the start of a run and after each step.
  void write_due();
  void visit_state(mpm::StateVisitor& visitor);
  /// Adds `probes`, where there are any, to the results of a run.
  void add_results(nlohmann::json& results) const;

 private:
  const mpm::Solver& solver_;
  std::vector<std::string> names_;  ///< of the probes
  std::optional<TrackedBodies> bodies_;
  std::vector<Probe> probes_;
  std::optional<Profiles> profiles_;
};

}  // namespace zona::studies
