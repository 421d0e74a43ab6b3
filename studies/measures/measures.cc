#include "studies/measures/measures.h"

#include <fmt/format.h>

#include "studies/measures/profile_table.h"
#include "studies/measures/section_table.h"

namespace zona::studies {

Measures::Measures(const Configuration& study, const mpm::Solver& solver,
                   const Eigen::Vector3d& origin, double end,
                   const std::filesystem::path& directory, bool is_resumed)
    : solver_(solver) {
  const std::vector<Table> probes = study.items<ProbeTable>();
  const bool has_profiles =
      !study.items<ProfileTable>().empty() || !study.items<SectionTable>().empty();
  if (!has_profiles && probes.empty()) return;
  bodies_.emplace(solver);
  for (const Table& table : probes) {
    names_.push_back(table.name());
    probes_.emplace_back(table.name(), table.read<ProbeTable>(), solver.grid(), origin, *bodies_);
  }
  if (has_profiles) profiles_.emplace(study, solver, origin, *bodies_, end, directory, is_resumed);
}

void Measures::add_columns(std::vector<ValueColumn<>>& columns) const {
  for (const Probe& probe : probes_) {
    for (ValueColumn<>& column : probe.columns()) columns.push_back(std::move(column));
  }
}

void Measures::sample() {
  if (!probes_.empty()) bodies_->refresh();
  for (Probe& probe : probes_) probe.sample(*bodies_);
}

void Measures::write_due() {
  if (!profiles_ || !profiles_->is_due(solver_)) return;
  bodies_->refresh();
  profiles_->write_due(solver_, *bodies_);
}

void Measures::visit_state(mpm::StateVisitor& visitor) {
  if (profiles_) profiles_->visit_state(visitor);
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    probes_[p].visit_state(fmt::format("probes/{}", p), visitor);
  }
}

void Measures::add_results(nlohmann::json& results) const {
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    results["probes"][names_[p]] = probes_[p].results();
  }
}

}  // namespace zona::studies
