#pragma once

#include "mpm/background_grid.h"
#include "mpm/body.h"
#include "mpm/scatter.h"

namespace zona::mpm {

/// Which velocity components a face holds at zero: none for free and absorbing faces, the normal one
/// for rollers, all for fixed faces.
bool holds(FaceCondition condition, int normal_axis, int axis);

/// Velocity and acceleration of the grid at the faces, after the momentum is advanced.
void hold_faces(BackgroundGrid& grid, const FaceConditions& faces);
/// The same for the velocities mapped back from the points.
void hold_updated_faces(BackgroundGrid& grid, const FaceConditions& faces);

/// Absorption rates (5.43)-(5.55) in the cell `index` for waves of the given speeds [m/s]; false where
/// no absorbing face bounds the cell.
bool absorption_rate(const BackgroundGrid& grid, const FaceConditions& faces,
                     const std::array<int, 3>& index, double wave_speed, double shear_wave_speed,
                     AbsorptionRate& rate);

/// Nodes that the points of a body touch, each once, in ascending order.
std::vector<int> touched_nodes(const BackgroundGrid& grid, const CellIndex& cells);

/// Gives nodes a velocity [m/s] after the momentum is advanced by dt [s]; returns the momentum that it
/// takes [N s].
Eigen::Vector3d override_velocity(BackgroundGrid& grid, const std::vector<int>& nodes,
                                  const Eigen::Vector3d& velocity, double dt);
void override_updated_velocity(BackgroundGrid& grid, const std::vector<int>& nodes,
                               const Eigen::Vector3d& velocity);

}  // namespace zona::mpm
