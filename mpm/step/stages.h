#pragma once

#include <vector>

#include "mpm/bodies/body.h"

namespace zona::mpm {

// The stages of a step between points and grid, for the points of one body in one brick. They
// select material and interpolation once per body and brick.

/// Scatters mass, momentum and internal force (3.30)-(3.32) from points to nodes, and adds up the
/// points of cells for an implicit pressure.
void scatter_brick(Body& body, int b, BackgroundGrid& grid);
/// Forgets the sums of cells of the brick that the body's points have left.
void clear_empty_cells(Body& body, int b, const BackgroundGrid& grid);

/// Moves the points to the end of a step of dt [s] with a fraction `pic` of PIC, and maps their
/// momentum back to the nodes (3.34)-(3.38).
void gather_brick(Body& body, int b, double dt, double pic, BackgroundGrid& grid);

/// Updates strains and stresses (3.40)-(3.42) of points that update_and_scatter_brick cannot
/// update, because these depend on other points or on a cell that the points leave: points of
/// membranes and averaged bodies, and points about to change cells. Returns the points whose state
/// is invalid.
std::vector<int> update_brick(Body& body, int b, double dt, const BackgroundGrid& grid);

/// Updates strains and stresses of all other points and scatters the points that are in the brick
/// now. Returns the points whose state is invalid.
std::vector<int> update_and_scatter_brick(Body& body, int b, double dt, BackgroundGrid& grid);

}  // namespace zona::mpm
