#pragma once

#include <vector>

#include "mpm/bodies/body.h"

namespace zona::mpm {

/// Sums over the points of a body, in the order of their ids, so that they do not depend on
/// storage.
struct BodyTotals {
  double mass = 0;                                     ///< [kg]
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< [kg m/s]
  double kinetic_energy = 0;                           ///< [J]
  /// Internal energy gained by a fluid, elastic energy of a solid or membrane [J].
  double stored_energy = 0;

  /// Adds each of the sums.
  BodyTotals& operator+=(const BodyTotals& other) {
    mass += other.mass;
    momentum += other.momentum;
    kinetic_energy += other.kinetic_energy;
    stored_energy += other.stored_energy;
    return *this;
  }
};

/// Of one body.
BodyTotals totals(const Body& body);
/// Of all bodies, those that move as prescribed included.
BodyTotals totals(const std::vector<Body>& bodies);

/// Sum of mass times position [kg m], in the order of ids.
Eigen::Vector3d first_moment(const Body& body);

/// Energy per mass [J/kg] of the point stored at `p`: internal of a fluid, elastic of a solid or
/// membrane, none of a body that moves as prescribed.
double specific_energy(const Body& body, int p);

/// Smallest and largest pressure of a fluid averaged over cells, by volume [Pa]. Pressure at single
/// points is noisy: linear shape functions do not see some of its patterns.
struct PressureRange {
  double lowest;   ///< of all cells [Pa]
  double highest;  ///< of all cells [Pa]
  double scatter;  ///< root mean square, by volume, of the points about their cell's average [Pa]
};
/// Over the cells that hold points of the fluid. Throws ModelError for any other material.
PressureRange cell_averaged_pressure(const Body& fluid_body);

/// Largest shear rate sqrt(2 D:D) [1/s] of a fluid's cells, from the deviator of its stress
/// averaged over a cell by volume, 2 mu D; 0 for a fluid without shear viscosity. Throws ModelError
/// for any other material.
double cell_averaged_shear_rate(const Body& fluid_body);

}  // namespace zona::mpm
