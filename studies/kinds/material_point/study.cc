#include "studies/kinds/material_point/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mpm/bodies/mixed_control.h"
#include "mpm/points/errors.h"
#include "studies/kinds/material_point/events.h"
#include "studies/kinds/material_point/material_table.h"
#include "studies/kinds/material_point/path_table.h"
#include "studies/kinds/material_point/point.h"
#include "studies/run/history_file.h"
#include "studies/run/interrupt.h"
#include "studies/run/progress.h"
#include "studies/run/run_directory.h"

namespace zona::studies {

namespace {

using mpm::PointSample;
using mpm::SymmetricTensor;

/// The components that a row holds: all, or those of a membrane.
std::vector<int> shown_components(const Configuration& study) {
  if (study.value(&PointMaterial::geometry) == PointGeometry::membrane) return kPlaneComponents;
  return {0, 1, 2, 3, 4, 5};
}

std::string component_name(int component) {
  return word_for(kStrainComponents, component);
}

std::vector<Column> columns(const std::vector<int>& shown) {
  std::vector<Column> result{{"step", ""}};
  for (int c : shown) result.push_back({fmt::format("strain_{}", component_name(c)), ""});
  for (int c : shown) result.push_back({fmt::format("stress_{}", component_name(c)), "Pa"});
  result.insert(result.end(), {{"equivalent_stress", "Pa"},
                               {"internal_variable", ""},
                               {"integrity", ""},
                               {"stored_energy", "J/m^3"},
                               {"flow_dissipation", "J/m^3"},
                               {"opening_dissipation", "J/m^2"}});
  return result;
}

std::vector<double> row(long step, const PointSample& s, const std::vector<int>& shown) {
  std::vector<double> values{static_cast<double>(step)};
  for (int c : shown) values.push_back(s.strain[c]);
  for (int c : shown) values.push_back(s.stress[c]);
  values.insert(values.end(), {mpm::equivalent_stress(s.stress), s.internal, s.left,
                               s.stored_energy, s.flow_dissipation, s.opening_dissipation});
  return values;
}

/// Drives the point along the path; records every step in the history and the events.
class PathRun {
 public:
  PathRun(const Configuration& study, const StrainPath& path, const std::filesystem::path& history)
      : point_(material_point(study)),
        targets_(path.targets()),
        free_(path.free_components()),
        steps_(path.steps),
        shown_(shown_components(study)),
        history_(history, columns(shown_)),
        events_(point_.sample()) {
    history_.add(row(0, point_.sample(), shown_));
  }

  void run(Progress& progress) {
    progress.start("path", static_cast<double>(targets_.size()));
    SymmetricTensor from{};
    for (std::size_t segment = 0; segment < targets_.size(); ++segment) {
      for (long s = 1; s <= steps_ && !Interrupt::requested(); ++s) {
        const double part = static_cast<double>(s) / static_cast<double>(steps_);
        SymmetricTensor target;
        for (int c = 0; c < 6; ++c) target[c] = from[c] + part * (targets_[segment][c] - from[c]);
        step(target);
        progress.update(static_cast<double>(segment) + part);
      }
      from = targets_[segment];
    }
    progress.finish();
  }

  nlohmann::json results() const { return events_.results(); }

 private:
  void step(const SymmetricTensor& target) {
    const double left = mpm::step_to(point_, target, free_);
    const PointSample sample = point_.sample();
    history_.add(row(++taken_, sample, shown_));
    events_.add(taken_, sample, left);
    const double scale = events_.largest_equivalent_stress();
    if (left <= 1e-6 * scale) return;
    throw RunError(fmt::format(
        "step {}: the free components of the path keep a stress of {:g} Pa; take more path.steps",
        taken_, left));
  }

  mpm::SinglePoint point_;
  std::vector<SymmetricTensor> targets_;
  mpm::FreeComponents free_;
  long steps_;
  std::vector<int> shown_;
  HistoryFile history_;
  PointEvents events_;
  long taken_ = 0;
};

}  // namespace

Job prepare_material_point(const Configuration& study) {
  material_point(study);
  return [study](Session& session) {
    PathRun run(study, study.read<StrainPath>(), session.directory.file("history.csv"));
    try {
      run.run(session.progress);
    } catch (...) {
      session.results = run.results();
      throw;
    }
    session.results = run.results();
  };
}

StudyCost estimate_material_point(const Configuration& study) {
  const auto path = study.read<StrainPath>();
  return {fmt::format("one point, {} segments of {} steps", path.targets().size(), path.steps)};
}

}  // namespace zona::studies
