#pragma once

namespace zona::studies::references {

/// A bar at rest; from t = 0 on a constant stress pulls both ends outwards. Elastic, perfectly
/// plastic, Poisson's ratio 0.
struct SteppedBar {
  double length;          ///< [m]
  double youngs_modulus;  ///< [Pa]
  double density;         ///< [kg/m^3]
  double yield_stress;    ///< [Pa]
  double step;            ///< of the tension at both ends, at most the yield stress [Pa]

  /// c = sqrt(E/rho) [m/s]
  double wave_speed() const;
  /// L/c [s]
  double transit_time() const { return length / wave_speed(); }
};

/// Table 3.2 with steps of 200 MPa.
SteppedBar bar_of_the_source();

/// State at one place and time.
struct BarState {
  double stress;             ///< axial [Pa]
  double equivalent_stress;  ///< von Mises [Pa]
  double velocity;           ///< axial [m/s]
  double plastic_strain;     ///< axial; without the concentrated one of the mid-section [-]
};

/// The bar with free sides: uniaxial stress, exact for all times, x in [0, L].
///
/// Elastically sigma - Z v = p travels to the right and sigma + Z v = q to the left, Z = rho c. An
/// end answers q with p = 2 step - q. Where the two fronts meet, at L/2, elasticity would give
/// twice the step; the section yields and carries no more than the yield stress s_y: it answers p
/// with q = 2 clamp(p, -s_y, s_y) - p and opens at 2 (p - clamp(p))/Z. Perfect plasticity has no
/// plastic wave, so all plastic strain is concentrated in this section, and everywhere else |sigma|
/// <= s_y. All is constant over periods of L/c. With the source's numbers: 300 MPa spreads from the
/// middle at c between 0.5 and 1 L/c while the section opens at 100 MPa * 2/Z = 14.06 m/s, the ends
/// unload it to 200 MPa, and from 1.5 L/c on the bar is at rest, 200 L/E = 27.8 mm longer in its
/// middle. Throws ModelError for x outside the bar, t < 0 or a step above the yield stress.
BarState free_bar_state(const SteppedBar& bar, double x, double time);

/// Plastic elongation of the mid-section of the bar with free sides [m].
double mid_section_opening(const SteppedBar& bar, double time);

/// The bar with held sides (one-dimensional strain), for t <= L/c.
///
/// Until the fronts meet it is the same, because Poisson's ratio is 0. Then the elastic front back
/// from the middle again carries the yield stress, but behind it the stress keeps rising: lateral
/// stress builds up, the tangent modulus is the bulk modulus E/3, and a plastic front runs at
/// c/sqrt(3). Behind that the material is at rest with the axial stress s_y + (2 step -
/// s_y)/sqrt(3) and an equivalent stress of s_y. The equivalent stress, which Figure 3.8 draws, is
/// therefore the same as with free sides. Throws as `free_bar_state`, and for later times.
BarState held_bar_state(const SteppedBar& bar, double x, double time);

}  // namespace zona::studies::references
