#include "studies/measures/tracked_bodies.h"

#include <stdexcept>

namespace zona::studies {

TrackedBodies::TrackedBodies(const mpm::Solver& solver) : solver_(&solver) {
  refresh();
  for (std::size_t b = 0; b < solver.bodies().size(); ++b) {
    start_.emplace_back();
    for (const int p : stored_[b]) start_.back().push_back(body(b).points.position_of(p));
  }
}

void TrackedBodies::refresh() {
  stored_.clear();
  for (const mpm::Body& body : solver_->bodies()) stored_.push_back(body.points.storage_by_id());
}

std::size_t TrackedBodies::index_of(const std::string& name) const {
  for (std::size_t b = 0; b < solver_->bodies().size(); ++b) {
    if (body(b).name == name) return b;
  }
  throw std::logic_error("there is no body " + name);
}

}  // namespace zona::studies
