#pragma once

#include <limits>
#include <vector>

#include "studies/references/axisymmetric_membrane.h"

namespace zona::studies::references {

/// Support of the egg opposite to the pipette.
enum class EggSupport {
  plate,           ///< flat, without friction
  sticking_plate,  ///< flat; what touches it sticks
  held             ///< the membrane within `support_radius` of the axis does not move
};

/// A spherical membrane full of fluid, initially unstressed, pressed by a rigid pipette along its
/// axis; no fluid outside. The membrane sticks to the pipette's face.
struct IndentedEgg {
  double radius;  ///< [m]
  MembraneLaw membrane;
  double pipette_outer;  ///< outer radius of the face [m]
  double pipette_inner;  ///< of the bore, into which the membrane bulges; 0: closed [m]
  double bulk_modulus = std::numeric_limits<double>::infinity();  ///< of the fluid [Pa]
  EggSupport support = EggSupport::plate;
  double support_radius = 0;  ///< for `held` [m]
  bool summed = false;        ///< strains as in (4.4)-(4.10), not objective
};

/// 5.2: diameter 60 um, zona 4.5 um, 17.9 kPa, 0.49; pipette 6 um outside, 5 um inside.
IndentedEgg egg_of_the_source();

/// Bulk modulus rho a^2 = (Gamma + 1)(P + P_inf) [Pa] at P = 0 of the stiffened gas (5.1).
double stiffened_gas_bulk_modulus(double grueneisen, double p_infinity);

struct IndentedEggState {
  double force;               ///< on the pipette [N]
  double displacement;        ///< of the pipette since it touched [m]
  double pressure;            ///< of the fluid [Pa]
  double volume_change;       ///< of the fluid, relative [-]
  double rim_stretch;         ///< along the meridian, at the pipette's outer edge [-]
  double rim_angle;           ///< of the membrane there, below the horizontal [rad]
  double contact_radius;      ///< on the plate [m]
  double bulge;               ///< of the membrane into the bore, above the face [m]
  double strain_energy;       ///< of a law that has one, else NaN [J]
  MeridianState shape;        ///< nodes from the bottom up
  Eigen::VectorXd reference;  ///< their undeformed coordinates, as MeridianState::position [m]
};

/// Equilibria at rising forces [N], by Newton's method in steps. `elements` on the meridian outside
/// the pipette, finer towards it. Throws ModelError for input that makes no sense and for forces
/// that the membrane cannot carry.
std::vector<IndentedEggState> indent_egg(const IndentedEgg& egg, const std::vector<double>& forces,
                                         int elements = 200);

}  // namespace zona::studies::references
