#pragma once

#include <vector>

#include "studies/references/membrane_law.h"

namespace zona::studies::references {

/// Strain of an element of a string.
enum class StringStrain {
  biot,         ///< lambda - 1
  logarithmic,  ///< ln lambda
  summed        ///< increments sym(du/l (x) t) summed in fixed axes and seen along the tangent t at
                ///< the end: (4.4), (4.5), which double the strain of small slopes
};

/// Contact of string and block.
enum class StringContact {
  bonded,  ///< no slip: the string under the block does not stretch, as with one velocity field
  sliding  ///< without friction: it stretches along the block's flat bottom
};

/// A rigid block that falls on the middle of a flat, unstressed string with fixed ends. Half of it
/// is computed; all quantities are those of the whole.
struct StringImpact {
  double length;          ///< between the fixed ends [m]
  double area;            ///< A_0, undeformed cross-section [m^2]
  double youngs_modulus;  ///< E [Pa]
  double density;         ///< [kg/m^3]
  double block_mass;      ///< [kg]
  double contact_length;  ///< of the block's bottom along the string; 0 is a point mass [m]
  double speed;           ///< of the block before it hits, downwards [m/s]
  StringStrain strain = StringStrain::logarithmic;
  StressMeasure stress = StressMeasure::kirchhoff;
  StringContact contact = StringContact::bonded;
};

/// Cuboid on a net: 4.4.2, Tables 4.1 and 4.2. Poisson's ratio of the net is 0 and its width that
/// of the cuboid, so that the net is a string of 0.2 m x 0.0125 m. The cuboid is taken as rigid (8
/// times the section of the net, of equal modulus).
StringImpact net_of_the_source();

struct StringSample {
  double time;            ///< [s]
  double displacement;    ///< of the block, up [m]
  double velocity;        ///< of the block, up [m/s]
  double contact_force;   ///< of the string on the block, up [N]
  double kinetic_energy;  ///< of block and string [J]
  double strain_energy;   ///< [J]
};

struct StringHistory {
  std::vector<StringSample> samples;  ///< at equal intervals, the first at t = 0
  double deepest = 0;                 ///< least displacement [m]
  double deepest_time = 0;            ///< [s]
  double lift_off_time = 0;   ///< when the string stops pushing; infinite if not reached [s]
  double largest_strain = 0;  ///< by the chosen measure
  double energy_error = 0;    ///< largest change of the energy over the initial one

  /// Displacement at a time within the samples, linear between them [m].
  double displacement(double time) const;
};

struct StringResolution {
  int elements = 400;      ///< on half of the string
  double end = 0.25;       ///< [s]
  double interval = 1e-3;  ///< between samples [s]
  double courant = 0.5;    ///< time step over the transit time of an element
};

/// Equal elements with masses at their nodes, tension T along each element, velocity Verlet.
/// With the undeformed volume, T = A_0 E e/lambda (Kirchhoff) or A_0 E e (nominal); no compression.
/// At t = 0 the block picks up the string under it: m_b V = (m_b + m_c) V', perfectly inelastic, as
/// in a method with one velocity field. When the contact force would become tensile, the block
/// leaves for good with the velocity it has. No gravity, as in the source. Throws ModelError.
StringHistory string_impact(const StringImpact& impact, const StringResolution& resolution = {});

}  // namespace zona::studies::references
