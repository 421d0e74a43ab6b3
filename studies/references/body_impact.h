#pragma once

namespace zona::studies::references {

/// An elastic body with a plane contact face.
struct ImpactBody {
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;   ///< [-]
  double density;         ///< [kg/m^3]
  double width;           ///< along the impact [m]

  /// Speed of plane dilatational waves, sqrt((lambda + 2 mu)/rho) [m/s].
  double wave_speed() const;
  /// Z = rho c_p [Pa s/m].
  double impedance() const { return density * wave_speed(); }
};

/// Two bodies of equal height in plane strain; the projectile runs into the resting target in +x.
struct BodyImpact {
  ImpactBody projectile, target;
  double speed;   ///< of the projectile [m/s]
  double height;  ///< across the impact, with free edges at both ends [m]
};

/// Aluminium on steel at 10 m/s: 3.3, Table 3.1.
BodyImpact impact_of_the_source();

enum class ImpactSide { projectile, target };

/// State of the material in the waves of one-dimensional strain.
struct ImpactState {
  double stress;          ///< sigma_x [Pa], tension positive
  double lateral_stress;  ///< sigma_y = sigma_z = nu/(1 - nu) sigma_x [Pa]
  double velocity;        ///< v_x [m/s]
};

/// State behind the first waves: continuity of stress and velocity at the contact give
/// sigma_x = -Z1 Z2 v/(Z1 + Z2) and the velocity Z1 v/(Z1 + Z2) of the contact, Z1 the
/// projectile's.
ImpactState impact_plateau(const BodyImpact& impact, ImpactSide side);

/// One-dimensional strain at `distance` [m] from the contact (undeformed) and `time` [s] after it:
/// undisturbed, plateau from distance/c_p on, unloaded from (2 width - distance)/c_p on by the
/// release from the free rear face. Throws ModelError for a distance outside the body, and for
/// times when a release has come back to the contact (min 2 width/c_p), where the bodies part.
ImpactState impact_state(const BodyImpact& impact, ImpactSide side, double distance, double time);

/// When the one-dimensional solution holds at a point [s].
struct ImpactWindow {
  double arrival;          ///< of the front from the contact
  double lateral_release;  ///< first arrival from a free edge: the plateau is not exact any more
  double rear_release;     ///< first arrival from a rear face: its own or, through the contact, the
                           ///< other's
  /// End of the exact plateau.
  double end() const { return lateral_release < rear_release ? lateral_release : rear_release; }
};

/// `distance` [m] from the contact, `from_edge` [m] from the nearer free edge. The first lateral
/// release leaves the corner of the contact at t = 0 with c_p of the body itself; in the slower
/// body one that runs along the contact in the faster body and turns in (a head wave) may be
/// earlier. Throws ModelError for a point outside the body.
ImpactWindow impact_window(const BodyImpact& impact, ImpactSide side, double distance,
                           double from_edge);

/// The place of point A in Figure 3.4 is not given. Here: in the target, 25 mm behind the contact,
/// at mid-height: near the contact, yet five cells or more from it on the two finer grids.
struct ImpactProbe {
  ImpactSide side = ImpactSide::target;
  double distance = 0.025;  ///< [m]
};

}  // namespace zona::studies::references
