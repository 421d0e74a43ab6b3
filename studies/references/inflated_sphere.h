#pragma once

#include "studies/references/membrane_law.h"

namespace zona::studies::references {

/// Pressure [Pa] in a spherical membrane of undeformed radius R [m] that has grown to `stretch` R.
/// Its power 4 pi r^2 p rate(r) is that of the tensions, 4 pi R^2 2 P rate(stretch):
///   p = 2 P/(R stretch^2); for a Kirchhoff law 2 h tau/(R stretch^3), tau = E e/(1 - nu).
/// The pressure has a maximum, at 1.5 for Biot strain (Kirchhoff) and e^(1/3) = 1.396 for the
/// logarithmic one; beyond, the sphere grows at falling pressure. Throws ModelError below 1.
double sphere_pressure(const MembraneLaw& law, double radius, double stretch);

/// Stretch at which the pressure is greatest.
double sphere_limit_stretch(const MembraneLaw& law);

/// Stretch under a pressure [Pa], on the rising branch. Throws ModelError above the greatest one.
double sphere_stretch(const MembraneLaw& law, double radius, double pressure);

}  // namespace zona::studies::references
