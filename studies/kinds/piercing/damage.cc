#include "studies/kinds/piercing/damage.h"

#include <algorithm>

namespace zona::studies {

DamageMeter::DamageMeter(const mpm::Body& zona, const mpm::Tube& tip)
    : away_(zona.points.size(), 1),
      counted_(zona.points.size(), 0),
      peak_strain_(zona.points.size(), 0.0),
      peak_displacement_(zona.points.size(), 0.0),
      tip_(tip),
      clearance_(2 * tip.outer_radius) {
  for (int p = 0; p < zona.points.size(); ++p) {
    reference_.push_back(zona.points.position_of(p));
    away_[p] = (reference_[p] - tip.end).norm() > tip.outer_radius + clearance_;
  }
}

void DamageMeter::widen_hole(const mpm::Membrane& membrane) {
  for (std::size_t f = 0; f < reference_.size(); ++f) {
    if (!membrane.failed(static_cast<int>(f)) || counted_[f]) continue;
    counted_[f] = 1;
    for (std::size_t p = 0; p < reference_.size(); ++p) {
      if (away_[p] && (reference_[p] - reference_[f]).norm() <= clearance_) away_[p] = 0;
    }
  }
}

double DamageMeter::peak_away(const std::vector<double>& peak) const {
  double largest = 0;
  for (std::size_t p = 0; p < peak.size(); ++p) {
    if (away_[p]) largest = std::max(largest, peak[p]);
  }
  return largest;
}

void DamageMeter::visit_state(mpm::StateVisitor& visitor) {
  visitor.visit("zona/away", away_);
  visitor.visit("zona/counted", counted_);
  visitor.visit("zona/peak_strain", peak_strain_);
  visitor.visit("zona/peak_displacement", peak_displacement_);
}

void ZonaDamage::visit_state(mpm::StateVisitor& visitor) {
  visitor.visit("zona/failed_points", failed_points);
  visitor.visit("zona/failed_area", failed_area);
  visitor.visit("zona/largest_strain", largest_strain);
  visitor.visit("zona/strain_away", strain_away);
  visitor.visit("zona/largest_displacement", largest_displacement);
  visitor.visit("zona/indentation", indentation);
}

bool DamageMeter::near_contact(std::size_t point) const {
  return (reference_[point] - tip_.end).norm() <= tip_.outer_radius + clearance_;
}

ZonaDamage DamageMeter::measure(const mpm::Body& zona) {
  const mpm::Membrane& membrane = *zona.membrane();
  widen_hole(membrane);
  ZonaDamage damage;
  for (int p = 0; p < zona.points.size(); ++p) {
    if (membrane.failed(p)) {
      ++damage.failed_points;
      damage.failed_area += membrane.reference_area[p];
      continue;
    }
    const Eigen::Vector3d moved = zona.points.position_of(p) - reference_[p];
    const double displacement = moved.norm();
    if (near_contact(p)) {
      damage.indentation = std::max(damage.indentation, -moved.dot(tip_.axis));
    }
    peak_strain_[p] = std::max(peak_strain_[p], membrane.strain[p]);
    peak_displacement_[p] = std::max(peak_displacement_[p], displacement);
    damage.largest_strain = std::max(damage.largest_strain, membrane.strain[p]);
    if (!away_[p]) continue;
    damage.strain_away = std::max(damage.strain_away, membrane.strain[p]);
    damage.largest_displacement = std::max(damage.largest_displacement, displacement);
  }
  return damage;
}

}  // namespace zona::studies
