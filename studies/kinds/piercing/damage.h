#pragma once

#include <cstdint>
#include <vector>

#include "mpm/bodies/body.h"
#include "studies/kinds/piercing/model.h"

namespace zona::studies {

/// Damage of the zona at an instant.
struct ZonaDamage {
  int failed_points = 0;
  double failed_area = 0;     ///< undeformed area of the failed points [m^2]
  double largest_strain = 0;  ///< largest principal strain of intact points [-]
  /// Largest principal strain of intact points farther than an outer diameter of the pipette from
  /// hole and contact [-].
  double strain_away = 0;
  double largest_displacement = 0;  ///< of the same points [m]
  /// Greatest displacement of the intact zona near the contact along the pipette's axis, away from
  /// the pipette [m].
  double indentation = 0;

  void visit_state(mpm::StateVisitor& visitor);
};

/// Measures the damage of the zona during a run. "Away from the hole" means, in the undeformed
/// zona, farther than one outer diameter of the pipette from every failed point and from the rim of
/// the contact.
class DamageMeter {
 public:
  DamageMeter(const mpm::Body& zona, const mpm::Tube& tip);

  ZonaDamage measure(const mpm::Body& zona);

  void visit_state(mpm::StateVisitor& visitor);

  /// Positions of the zona's points before the run [m].
  const std::vector<Eigen::Vector3d>& reference() const { return reference_; }

  /// Largest strain [-] and displacement [m] over all measurements so far, of the points that are
  /// away from the present hole.
  double peak_strain_away() const { return peak_away(peak_strain_); }
  double peak_displacement_away() const { return peak_away(peak_displacement_); }

 private:
  double peak_away(const std::vector<double>& peak) const;
  bool near_contact(std::size_t point) const;
  void widen_hole(const mpm::Membrane& membrane);

  std::vector<Eigen::Vector3d> reference_;
  std::vector<std::int32_t> away_;     ///< 1 or 0
  std::vector<std::int32_t> counted_;  ///< 1 or 0
  std::vector<double> peak_strain_;
  std::vector<double> peak_displacement_;
  mpm::Tube tip_;
  double clearance_;
};

}  // namespace zona::studies
