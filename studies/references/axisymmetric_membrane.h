#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "studies/references/membrane_law.h"

namespace zona::studies::references {

/// Meridian of a membrane of revolution: nodes (r, z), joined in their order, which runs from the
/// bottom to the top, so that the enclosed volume is positive. Coordinates are stored r0 z0 r1
/// z1...
struct Meridian {
  MembraneLaw law;
  Eigen::VectorXd reference;  ///< undeformed, unstressed [m]
  bool summed = false;  ///< strains as in (4.4)-(4.10): increments from one equilibrium to the
                        ///< next, summed in fixed axes; else the law's measure of the stretches

  int nodes() const { return static_cast<int>(reference.size()) / 2; }
};

/// Supports and loads of the membrane.
struct MeridianLoads {
  std::vector<int> unknown;  ///< per coordinate the number of its unknown; -1 holds it. Coordinates
                             ///< with one number move by the same amount
  int loaded = -1;           ///< unknown that a force acts on; -1 for none
  double force = 0;          ///< along its coordinate [N]
  double plate_stiffness = 0;  ///< pressure of a plate z = 0 per depth below it [Pa/m]; 0: none
  bool filled = false;  ///< with a fluid of volume and bulk modulus, else `pressure` is given
  double pressure = 0;  ///< inside minus outside [Pa]
  double volume = 0;    ///< of the fluid without pressure [m^3]
  double bulk_modulus =
      std::numeric_limits<double>::infinity();  ///< K in V = volume (1 - p/K) [Pa]
  double unwrinkled_share = 1e-6;  ///< of the law without wrinkles, mixed into wrinkled and slack
                                   ///< parts, which would have no stiffness at all

  int unknowns() const;
};

struct MeridianState {
  Eigen::VectorXd position;  ///< as Meridian::reference [m]
  double pressure = 0;       ///< inside minus outside [Pa]
  Eigen::VectorXd last;      ///< position of the last equilibrium; empty before the first one
  std::vector<Eigen::Vector4d> summed;  ///< then: strain rr, zz, rz, hoop of every element
};

/// Volume between the membrane and the axis [m^3]; of a closed meridian the enclosed one.
double enclosed_volume(const Eigen::VectorXd& position);

/// Stretches of an element along the meridian and around the axis, at its middle.
struct MeridianStretch {
  double along, around;
};
MeridianStretch stretch_at(const Meridian& meridian, const Eigen::VectorXd& position, int element);

/// Equilibrium by Newton's method, starting from `state`: straight (conical) elements with
/// stretches l/L and (r1 + r2)/(R1 + R2), tensions of the law, the pressure as the gradient of the
/// volume. Returns the number of iterations; throws ModelError when it does not converge.
int find_equilibrium(const Meridian& meridian, const MeridianLoads& loads, MeridianState& state);

/// Equilibria along a path: `set` gives the loads at a parameter that runs from 0 to 1, in steps
/// that are halved where Newton's method fails and grow where it succeeds. Throws ModelError where
/// even 1/2^12 of `first_step` fails: the membrane can carry no more.
void follow_equilibrium(const Meridian& meridian, MeridianLoads& loads, MeridianState& state,
                        const std::function<void(double, MeridianLoads&)>& set, double first_step);

}  // namespace zona::studies::references
