#pragma once

#include "studies/references/membrane_law.h"

namespace zona::studies::references {

/// A strip of membrane under tension along its length.
struct StripState {
  double stress;           ///< of the law, along the strip [Pa]
  double lateral_stress;   ///< of the law, across the strip [Pa]
  double tension;          ///< per undeformed width [N/m]
  double lateral_stretch;  ///< current over undeformed width, wrinkles drawn flat [-]
  MembraneState state;
};

/// Free long edges: uniaxial stress E e, lateral strain -nu e. `stretch` is along the strip; at or
/// below one it is slack. Throws ModelError for a stretch that is not positive, and for
/// `Wrinkling::strain`, which pulls across at any contraction: a free strip has no equilibrium.
StripState free_strip(const MembraneLaw& law, double stretch);

/// Long edges held at `lateral_stretch` times their distance. At 1: stress E e/(1 - nu^2) and nu
/// times that across. If they approach by more than a free strip contracts, it wrinkles and has the
/// stress of a free strip.
StripState held_strip(const MembraneLaw& law, double stretch, double lateral_stretch);

/// Pure bending, in its plane, of a strip under tension: a band along the compressed edge wrinkles
/// (Stein and Hedgepeth, Analysis of partly wrinkled membranes, NASA TN D-813, 1961). Small
/// strains, the ends stay straight, so that e is linear across the strip.
struct BentStrip {
  double youngs_modulus;  ///< E [Pa]
  double thickness;       ///< t [m]
  double height;          ///< h, in the plane of bending [m]
  double tension;         ///< P, total [N]
};

struct BentStripState {
  double curvature;       ///< [1/m]
  double band;            ///< height b of the wrinkled band [m]
  double largest_stress;  ///< at the tensioned edge [Pa]
};

/// State under a moment M [N m]. With m = M/(P h): up to 1/6 the strip is a beam,
///   E h^2 t kappa/(2 P) = 6 m, b = 0;
/// beyond, the stress rises linearly from zero at the band's edge, and force and moment give
///   b/h = 3 m - 1/2, E h^2 t kappa/(2 P) = 1/(1 - b/h)^2 = (4/9)/(1 - 2 m)^2;
/// at 1/2 the strip has collapsed. Throws ModelError for m outside [0, 1/2).
BentStripState bent_strip(const BentStrip& strip, double moment);

/// The moment [N m] that a curvature >= 0 [1/m] takes; the inverse of the above.
double bent_strip_moment(const BentStrip& strip, double curvature);

}  // namespace zona::studies::references
