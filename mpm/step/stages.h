#pragma once

#include <vector>

#include "mpm/bodies/body.h"

namespace zona::mpm {

/// The stages of a step between points and grid, for the points of one body in one brick. Material
/// and interpolation are chosen here, once per body and brick.

/// Mass, momentum and internal force (3.30)-(3.32), points to nodes.
void scatter_brick(const Body& body, int b, BackgroundGrid& grid);

/// Velocities and positions at the end of a step of dt [s] with a fraction `pic` of PIC, and the
/// momentum mapped back (3.34)-(3.38).
void gather_brick(Body& body, int b, double dt, double pic, BackgroundGrid& grid);

/// Strains and stresses (3.40)-(3.42) of the points that cannot wait for update_and_scatter_brick,
/// because more than the points of their cell or another cell has a part in them: those of
/// membranes and averaged bodies, and those about to leave their cell. Returns the points whose
/// state lost its meaning.
std::vector<int> update_brick(Body& body, int b, double dt, const BackgroundGrid& grid);

/// Strains and stresses of all other points, and what scatter_brick does, for the points that are
/// in the brick now. Returns the points whose state lost its meaning.
std::vector<int> update_and_scatter_brick(Body& body, int b, double dt, BackgroundGrid& grid);

}  // namespace zona::mpm
