#pragma once

#include "beam/section.h"

namespace zona::beam {

/// Injection pipette clamped in its capillary: a glass tube with its bore full of one fluid.
/// The defaults decode Tables 5.5 and 5.6; what is not a property of the tube itself (the number of
/// elements, Rayleigh damping C = alpha M + beta K) is how its vibration is computed.
struct Pipette {
  double length = 10e-3;            ///< free length [m]
  double outer_diameter = 10e-6;    ///< [m]
  double inner_diameter = 8e-6;     ///< [m]
  double youngs_modulus = 63.44e9;  ///< of the glass [Pa]
  double density = 2300;            ///< of the glass [kg/m^3]
  double fill_density = 0;          ///< of the fluid in the bore [kg/m^3]
  int elements = 20;                ///< Hermite cubic elements
  double damping_alpha = 0;         ///< mass-proportional Rayleigh damping [1/s]
  double damping_beta = 0;          ///< stiffness-proportional Rayleigh damping [s]
};

/// Throws std::invalid_argument that names the value, the limit and the remedy unless the pipette
/// is a tube (0 <= inner < outer diameter), slender enough for Euler-Bernoulli theory (length at
/// least ten diameters), of positive modulus and density, and damped by nothing negative.
void check(const Pipette& pipette);

/// Second moment of area of the glass ring, pi (D^4 - d^4) / 64 [m^4].
double second_moment_of_area(const Pipette& pipette);

/// Glass and fill per length, pi/4 ((D^2 - d^2) rho + d^2 rho_fill) [kg/m].
double mass_per_length(const Pipette& pipette);

/// The pipette as the analytic solutions see it. Calls check().
UniformBeam uniform_beam(const Pipette& pipette);

}  // namespace zona::beam
