#include "studies/measures/probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zona::studies {

Probe::Probe(const std::string& name, const ProbeTable& table, const mpm::BackgroundGrid& grid,
             const Eigen::Vector3d& origin, const TrackedBodies& bodies)
    : name_(name),
      body_(bodies.index_of(table.body)),
      quantities_(table.quantities),
      is_point_(table.kind == ProbeKind::point) {
  if (is_point_) {
    choose_nearest(origin + table.place, bodies);
    return;
  }
  box_ = table.in(grid, origin);
  is_current_ = table.membership == Membership::current;
  for (int id = 0; id < bodies.point_count(body_); ++id) {
    if (box_.contains(bodies.start_of(body_, id))) ids_.push_back(id);
  }
}

void Probe::choose_nearest(const Eigen::Vector3d& place, const TrackedBodies& bodies) {
  distance_ = std::numeric_limits<double>::infinity();
  for (int id = 0; id < bodies.point_count(body_); ++id) {
    const double distance = (bodies.start_of(body_, id) - place).norm();
    if (distance >= distance_) continue;
    distance_ = distance;
    ids_ = {id};
  }
  start_ = bodies.start_of(body_, ids_.front());
}

std::vector<Column> Probe::headings() const {
  std::vector<Column> headings;
  for (const PointQuantity* quantity : quantities_) {
    for (Column& column : columns_of(*quantity, "probe." + name_ + ".")) headings.push_back(column);
  }
  return headings;
}

std::vector<ValueColumn<>> Probe::columns() const {
  std::vector<ValueColumn<>> columns;
  for (const Column& heading : headings()) {
    const std::size_t c = columns.size();
    columns.push_back({heading.name, heading.unit, [this, c] { return extremes_.at(c).last; }});
  }
  return columns;
}

PointValues Probe::values(const TrackedBodies& bodies) const {
  if (is_point_) return bodies.values(body_, ids_.front());
  PointMean mean;
  if (!is_current_) {
    for (const int id : ids_) mean.add(bodies.values(body_, id));
  } else {
    for (int id = 0; id < bodies.point_count(body_); ++id) {
      if (box_.contains(bodies.place_of(body_, id))) mean.add(bodies.values(body_, id));
    }
  }
  return mean.mean();
}

void Probe::sample(const TrackedBodies& bodies) {
  const PointValues now = values(bodies);
  std::vector<double> row;
  for (const PointQuantity* quantity : quantities_) {
    const auto first = now.value.begin() + static_cast<std::ptrdiff_t>(quantity->first);
    row.insert(row.end(), first, first + static_cast<std::ptrdiff_t>(quantity->components.size()));
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  extremes_.resize(row.size(), {nan, nan, nan});
  for (std::size_t c = 0; c < row.size(); ++c) {
    extremes_[c].last = row[c];
    extremes_[c].lowest = std::fmin(extremes_[c].lowest, row[c]);
    extremes_[c].highest = std::fmax(extremes_[c].highest, row[c]);
  }
}

void Probe::visit_state(const std::string& name, mpm::StateVisitor& visitor) {
  extremes_.resize(headings().size());
  for (std::size_t c = 0; c < extremes_.size(); ++c) {
    const std::string column = name + "/" + std::to_string(c);
    visitor.visit(column + "/last", extremes_[c].last);
    visitor.visit(column + "/lowest", extremes_[c].lowest);
    visitor.visit(column + "/highest", extremes_[c].highest);
  }
}

nlohmann::json Probe::results() const {
  nlohmann::json result;
  if (is_point_) {
    result["point"] = ids_.front();
    result["start"] = {start_.x(), start_.y(), start_.z()};
    result["distance"] = distance_;
  } else if (!is_current_) {
    result["points"] = ids_.size();
  }
  const std::string prefix = "probe." + name_ + ".";
  const std::vector<Column> all = headings();
  for (std::size_t c = 0; c < extremes_.size(); ++c) {
    const Extremes& e = extremes_[c];
    result[all[c].name.substr(prefix.size())] = {
        {"final", e.last}, {"lowest", e.lowest}, {"highest", e.highest}};
  }
  return result;
}

}  // namespace zona::studies
