#pragma once

#include <vector>

#include "studies/references/triangle_membrane.h"

namespace zona::studies::references {

/// A rigid box of gas under pressure whose square lid is a membrane, held along its edges, with a
/// cube in its middle; vacuum outside. A model of 4.4.3, not an exact solution: the gas is uniform
/// and adiabatic, p V^gamma = const, without inertia; the cube is rigid and stays attached.
struct GasBox {
  double side;              ///< of the lid [m]
  double height;            ///< of the box [m]
  double pressure;          ///< initial, of the gas [Pa]
  double gamma;             ///< ratio of specific heats [-]
  MembraneLaw membrane;     ///< thickness included
  double membrane_density;  ///< [kg/m^3]
  double cube_side;         ///< [m]
  double cube_density;      ///< [kg/m^3]
  TriangleStrain strain = TriangleStrain::stretches;
  bool rigid_cube = true;  ///< otherwise only its mass sits on the membrane: a bound
};

/// 4.4.3, Table 4.3; gamma = 1.4.
GasBox box_of_the_source();

struct GasBoxSample {
  double time;            ///< [s]
  double displacement;    ///< of the cube (mean over its footprint), up [m]
  double velocity;        ///< of the cube, up [m/s]
  double pressure;        ///< of the gas [Pa]
  double volume;          ///< of the gas [m^3]
  double highest;         ///< greatest displacement of the membrane [m]
  double kinetic_energy;  ///< of membrane and cube [J]
  double strain_energy;   ///< work done on the membrane [J]
  double gas_energy;      ///< p V/(gamma - 1) [J]
};

struct GasBoxHistory {
  std::vector<GasBoxSample> samples;  ///< at equal intervals, the first at t = 0
  double largest_strain = 0;          ///< principal, in the chosen measure, at the samples
  double energy_error = 0;  ///< largest change of the energy over the greatest work of the gas

  /// Displacement of the cube at a time within the samples, linear between them [m].
  double displacement(double time) const;
};

struct GasBoxResolution {
  int squares = 50;        ///< along half of the lid; the cube's edge must be a line of the mesh
  double end = 0.03;       ///< [s]
  double interval = 5e-4;  ///< between samples [s]
  double courant = 0.4;    ///< time step over the transit time of a square's side
};

/// A quarter of the lid in constant-strain triangles with masses at their nodes; the force of the
/// gas is p times the gradient of the volume, so that gas and membrane exchange energy exactly;
/// velocity Verlet. Throws ModelError for input that makes no sense, and when triangles invert.
GasBoxHistory gas_box(const GasBox& box, const GasBoxResolution& resolution = {});

/// Fraction by which the inertia of the gas slows a lid of uniform mass [kg/m^2]: the velocity of
/// the gas is linear from the bottom to the lid, which adds a third of its mass.
double gas_inertia(double gas_density, double height, double lid_mass);

}  // namespace zona::studies::references
