#include "studies/kinds/material_point/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mpm/bodies/mixed_control.h"
#include "mpm/points/errors.h"
#include "studies/kinds/material_point/events.h"
#include "studies/kinds/material_point/path.h"
#include "studies/parameters/material_parameters.h"
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
  if (study.choice("material.geometry") == "membrane") return {0, 1, 3};
  return {0, 1, 2, 3, 4, 5};
}

std::vector<Column> columns(const std::vector<int>& shown) {
  std::vector<Column> result{{"step", ""}};
  for (int c : shown) result.push_back({fmt::format("strain_{}", strain_components[c]), ""});
  for (int c : shown) result.push_back({fmt::format("stress_{}", strain_components[c]), "Pa"});
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

mpm::VonMises plasticity(const Configuration& study) {
  mpm::VonMises law = von_mises_from(study, "material.");
  if (study.choice("material.law") == "decohesion") {
    const double edge = study.quantity("material.cell");
    law.decohesion = decohesion_from(study, "material.", Eigen::Vector3d::Constant(edge));
    law.decohesion->localization = localization_of(study.choice("material.bifurcation"));
  }
  return law;
}

/// What the study's law is, as a law of solids or of membranes.
template <class Law>
Law law_of(const Configuration& study) {
  const std::string& name = study.choice("material.law");
  if (name == "elastic") return mpm::Elastic{};
  if (name == "elastodamage") return elastodamage_from(study, "material.");
  return plasticity(study);
}

/// Leads the point along the path; every step goes into the history and the events.
class PathRun {
 public:
  PathRun(const Configuration& study, const std::filesystem::path& history)
      : point_(material_point(study)),
        targets_(path_strains(study)),
        free_(free_components(study)),
        steps_(study.integer("path.steps")),
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

mpm::SinglePoint material_point(const Configuration& study) {
  const double modulus = study.quantity("material.youngs_modulus");
  const double nu = study.number("material.poisson_ratio");
  if (study.choice("material.geometry") == "solid") {
    return {mpm::ElasticModuli{modulus, nu}, law_of<mpm::SolidLaw>(study)};
  }
  const mpm::MembraneProperties properties{1000, 1, modulus, nu,
                                           one_way_of(study.choice("material.one_way"))};
  if (study.choice("material.stress_update") == "increments") {
    return {properties, mpm::MembraneLaw(mpm::IncrementalElastic{})};
  }
  return {properties, law_of<mpm::MembraneLaw>(study)};
}

Job prepare_material_point(const Configuration& study) {
  material_point(study);
  return [study](Session& session) {
    PathRun run(study, session.directory.file("history.csv"));
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
  return {fmt::format("one point, {} segments of {} steps", path_strains(study).size(),
                      study.integer("path.steps"))};
}

}  // namespace zona::studies
