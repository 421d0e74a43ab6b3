#pragma once

#include "studies/input/configuration.h"

namespace zona::studies {

/// Values of a piercing that follow from its parameters, among them every "auto" that needs no
/// simulation. All in SI.

/// Mean distance of neighbouring membrane points [m]: 1.107 R / 2^level, the icosahedron's edge
/// 1.107 R (along the sphere) divided `zona.level` times.
double zona_edge_length(const Configuration& study);

/// Density [kg/m^3] of the tip's points when a fluid of the given density [kg/m^3] fills the bore:
/// pipette.point_density, or for "auto" the glass plus the fluid spread evenly over the glass.
double pipette_point_density(const Configuration& study, double fluid_density);

/// Amplitude [m] of a sine or peak [m] of a triangle: motion.amplitude, or for "auto" the source's
/// 13.5 um and 1.8 um.
double motion_amplitude(const Configuration& study);

/// End of the simulation [s]: time.end, or for "auto" one period of a sine, the duration of a
/// triangle, the window of a beam or a trace, which must lie within the history.
double simulation_end(const Configuration& study);

}  // namespace zona::studies
