#pragma once

#include "studies/verification/evaluation/verification_case.h"

namespace zona::studies::verification {

// Chapter 3
Case impact();
Case bar_wave();
// Chapter 4
Case shock_tube();
Case sod_tube();
Case net();
Case gas_box();
// Chapter 5
Case material_points();
Case piston();
Case oblique_wave();
Case injection();
Case piercing_lateral();
Case piercing_axial();
Case piercing_numerics();
Case pipette_frequencies();
Case support_motion();
Case pipette_amplitude();
Case pipette_bath();
// What the source lacks
Case membrane_strip();
Case membrane_shear();
Case inflated_sphere();
Case hencky();
Case membrane_bending();
Case stokes();
Case couette();
Case standing_wave();
Case free_fall();
// Choices of the scheme
Case vortex();
Case drifting_bar();
Case hanging_bar();

}  // namespace zona::studies::verification
