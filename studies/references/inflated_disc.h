#pragma once

#include "studies/references/axisymmetric_membrane.h"

namespace zona::studies::references {

/// A flat, unstressed, clamped disc under a pressure that stays normal to it, without restriction
/// of rotations or strains: Hencky's problem at finite deflections. For small loads it tends to
/// his.
struct InflatedDisc {
  double deflection;      ///< of the middle [m]
  double middle_stretch;  ///< equal in all directions [-]
  double edge_stretch;    ///< along the meridian [-]
  double volume;          ///< under the disc [m^3]
  MeridianState state;    ///< nodes from the edge to the middle
};
InflatedDisc inflate_disc(const MembraneLaw& law, double radius, double pressure,
                          int elements = 200);

}  // namespace zona::studies::references
