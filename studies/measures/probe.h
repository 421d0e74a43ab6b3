#pragma once

#include <nlohmann/json.hpp>

#include "studies/measures/probe_table.h"
#include "studies/measures/tracked_bodies.h"

namespace zona::studies {

/// A [[probe]]: quantities of a point or of a mean, as columns of history.csv, and their extremes.
class Probe {
 public:
  /// Places in the table count from `origin` [m].
  Probe(const std::string& name, const ProbeTable& table, const mpm::BackgroundGrid& grid,
        const Eigen::Vector3d& origin, const TrackedBodies& bodies);

  /// "probe.NAME.stress_xx", ... with the values of the last `sample`; they refer to this object.
  std::vector<ValueColumn<>> columns() const;
  /// Measures; NaN for a mean of no points.
  void sample(const TrackedBodies& bodies);
  void visit_state(const std::string& name, mpm::StateVisitor& visitor);
  /// Number of the point, or how many points; last, lowest and highest value of each column so far.
  nlohmann::json results() const;

 private:
  std::vector<Column> headings() const;
  PointValues values(const TrackedBodies& bodies) const;
  void choose_nearest(const Eigen::Vector3d& place, const TrackedBodies& bodies);

  struct Extremes {
    double last, lowest, highest;
  };

  std::string name_;
  std::size_t body_;
  std::vector<const PointQuantity*> quantities_;
  bool is_point_;
  bool is_current_ = false;  ///< the mean is over the points that are in the box at present
  std::vector<int> ids_;     ///< of the point, or of those in the box at the start
  Eigen::Vector3d start_;    ///< of the point [m]
  double distance_ = 0;      ///< of the point from the wanted place [m]
  mpm::Box box_;
  std::vector<Extremes> extremes_;
};

}  // namespace zona::studies
