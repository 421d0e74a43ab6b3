#pragma once

#include <vector>

#include "mpm/grid/region.h"
#include "mpm/step/solver.h"
#include "studies/measures/point_values.h"

namespace zona::studies {

/// Bodies of a solver, their points found by id wherever they are stored, and the places that the
/// points started from. Make it before the first step; the solver must outlive it.
class TrackedBodies {
 public:
  explicit TrackedBodies(const mpm::Solver& solver);

  /// Finds the points again; call it after steps, before any other call.
  void refresh();

  std::size_t body_count() const { return solver_->bodies().size(); }
  std::size_t index_of(const std::string& body) const;
  const mpm::Body& body(std::size_t b) const { return solver_->bodies()[b]; }
  int point_count(std::size_t b) const { return static_cast<int>(start_[b].size()); }
  const Eigen::Vector3d& start_of(std::size_t b, int id) const { return start_[b][id]; }
  Eigen::Vector3d place_of(std::size_t b, int id) const {
    return body(b).points.position_of(stored_[b][id]);
  }
  PointValues values(std::size_t b, int id) const {
    return values_at(body(b), stored_[b][id], start_[b][id]);
  }

 private:
  const mpm::Solver* solver_;
  std::vector<std::vector<Eigen::Vector3d>> start_;
  std::vector<std::vector<int>> stored_;
};

}  // namespace zona::studies
