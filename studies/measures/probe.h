#pragma once

#include <nlohmann/json.hpp>

#include "studies/input/configuration.h"
#include "studies/measures/tracked_bodies.h"

namespace zona::studies {

/// A [[probe]]: a point or a mean, its columns in history.csv and what is kept of them.
class Probe {
 public:
  /// Places in the table count from `origin` [m].
  Probe(const Table& table, const mpm::BackgroundGrid& grid, const Eigen::Vector3d& origin,
        const TrackedBodies& bodies);

  /// "probe.NAME.stress_xx", ...
  std::vector<Column> columns() const;
  /// Present values, in the order of the columns; NaN for a mean of no points.
  std::vector<double> sample(const TrackedBodies& bodies);
  void visit_state(const std::string& name, mpm::StateVisitor& visitor);
  /// Which point it is, or how many; last, lowest and highest value of each column so far.
  nlohmann::json results() const;

 private:
  PointValues values(const TrackedBodies& bodies) const;
  void choose_nearest(const Eigen::Vector3d& place, const TrackedBodies& bodies);

  struct Extremes {
    double last, lowest, highest;
  };

  std::string name_;
  std::size_t body_;
  std::vector<PointQuantity> quantities_;
  bool is_point_;
  bool is_current_ = false;  ///< the box is asked again every time
  std::vector<int> ids_;     ///< of the point, or of those in the box at the start
  Eigen::Vector3d start_;    ///< of the point [m]
  double distance_ = 0;      ///< of the point from the wanted place [m]
  mpm::Box box_;
  std::vector<Extremes> extremes_;
};

}  // namespace zona::studies
