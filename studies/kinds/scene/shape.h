#pragma once

#include <functional>

#include "mpm/bodies/lattice.h"
#include "studies/kinds/scene/shape_table.h"

namespace zona::studies {

/// Whether a place [m] lies in a body's shape.
using Inside = std::function<bool(const Eigen::Vector3d&)>;

/// Volume that a [[body]] encloses: its shape, the ball in an icosphere, none for a sheet or disc.
/// Boxes include their lower faces but not their upper ones, so that neighbours share no point.
Inside inside_of(const BodyShape& body, const mpm::BackgroundGrid& grid);

/// Points of a body with a volume, without those where `cut` is true.
mpm::Lattice volume_points(const BodyShape& body, const mpm::BackgroundGrid& grid,
                           const Inside& inside, const Inside& cut);

/// Points and triangles of a sheet, disc or icosphere, numbered as they lie in space; each point
/// has a third of the area of the triangles around it.
struct WeightedSurface {
  mpm::TriangulatedSurface surface;
  std::vector<double> areas;  ///< [m^2]
};
WeightedSurface surface_points(const BodyShape& body, const mpm::BackgroundGrid& grid);

}  // namespace zona::studies
