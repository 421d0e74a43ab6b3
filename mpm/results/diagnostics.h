#pragma once

#include <vector>

#include "mpm/bodies/body.h"

namespace zona::mpm {

/// Sums over the points of a body, in the order of their ids, independent of the order of storage.
struct BodyTotals {
  double mass = 0;                                     ///< [kg]
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< [kg m/s]
  double kinetic_energy = 0;                           ///< [J]
  /// Gain in internal energy of a fluid, elastic energy of a solid or membrane [J].
  double stored_energy = 0;

  /// Adds the sums of another body.
  BodyTotals& operator+=(const BodyTotals& other) {
    mass += other.mass;
    momentum += other.momentum;
    kinetic_energy += other.kinetic_energy;
    stored_energy += other.stored_energy;
    return *this;
  }
};

/// Totals of one body.
BodyTotals totals(const Body& body);
/// Totals of all bodies, including those with prescribed motion.
BodyTotals totals(const std::vector<Body>& bodies);

/// Sum of mass times position [kg m], in the order of ids.
Eigen::Vector3d first_moment(const Body& body);

/// Energy per mass [J/kg] of the point stored at `p`: internal energy of a fluid, elastic energy of
/// a solid or membrane, zero for a body with prescribed motion.
double specific_energy(const Body& body, int p);

/// Range of a fluid's pressure, averaged over cells by volume. The pressure of single points is
/// noisy, because linear shape functions cannot represent some of its patterns.
struct PressureRange {
  double lowest;   ///< over all cells [Pa]
  double highest;  ///< over all cells [Pa]
  double scatter;  ///< volume-weighted RMS deviation of the points from their cell's average [Pa]
};
/// Range over the cells that contain points of the fluid. Throws ModelError for other materials.
PressureRange cell_averaged_pressure(const Body& fluid_body);

/// Largest shear rate sqrt(2 D:D) [1/s] in the cells of a fluid, from the deviator 2 mu D of the
/// stress averaged over a cell by volume; 0 for a fluid without shear viscosity. Throws ModelError
/// for other materials.
double cell_averaged_shear_rate(const Body& fluid_body);

}  // namespace zona::mpm
