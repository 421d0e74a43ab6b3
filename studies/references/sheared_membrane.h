#pragma once

#include "studies/references/membrane_law.h"

namespace zona::studies::references {

/// In-plane stress of a sheared membrane, x along the shear.
struct ShearedState {
  double xx, yy, xy;  ///< [Pa]
  MembraneState state;
};

/// Small strains: exx = eyy = `prestrain`, engineering shear `gamma`. Taut, xy = G gamma. It
/// wrinkles from gamma = 2 prestrain (1 + nu)/(1 - nu) on; then the stress is uniaxial along the
/// largest strain, at 45 degrees: xx = yy = xy = E (prestrain + gamma/2)/2 (tension field; E
/// gamma/4 without prestrain, half of G gamma or less). This is also exact at any shear for strain
/// increments summed in fixed axes, the source's kinematics, because simple shear is then linear.
ShearedState linearly_sheared(const MembraneLaw& law, double prestrain, double gamma);

/// The gamma at which wrinkling begins, small strains.
double wrinkling_shear(const MembraneLaw& law, double prestrain);

/// Simple shear F = [1 gamma; 0 1] times an equal prestretch in both directions: the law's stress
/// at the principal stretches, along the principal axes of the deformed membrane (eigenvectors of F
/// F^T). For a Kirchhoff law this is what a material point carries.
ShearedState finitely_sheared(const MembraneLaw& law, double prestretch, double gamma);

}  // namespace zona::studies::references
