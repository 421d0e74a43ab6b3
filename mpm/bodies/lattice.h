#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "mpm/grid/background_grid.h"
#include "mpm/membranes/surface.h"

namespace zona::mpm {

/// Places of points and the volume [m^3] that each stands for.
struct Lattice {
  std::vector<Eigen::Vector3d> places;  ///< [m]
  std::vector<double> volumes;          ///< [m^3], one of each place

  /// One point more.
  void add(const Eigen::Vector3d& place, double volume) {
    places.push_back(place);
    volumes.push_back(volume);
  }
  double volume() const;  ///< of all points [m^3]
};

/// A regular lattice of `per_cell` points along each axis in every cell of the grid, as far as
/// `inside` says yes: boxes, spheres and what is left of them.
Lattice fill_cells(const BackgroundGrid& grid, const std::array<int, 3>& per_cell,
                   const std::function<bool(const Eigen::Vector3d&)>& inside);

/// Box [low, high) with `count` points along each axis, independent of the grid.
Lattice box(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
            const std::array<int, 3>& count);

/// A straight tube: a hollow cylinder.
struct Tube {
  Eigen::Vector3d end;   ///< centre of the end that the axis starts from [m]
  Eigen::Vector3d axis;  ///< unit vector from that end into the tube
  double length;         ///< [m]
  double inner_radius;   ///< [m]
  double outer_radius;   ///< [m]
};

/// Points at the middle of `radial` x `circumferential` x `axial` equal divisions of a tube's wall.
Lattice tube(const Tube& tube, int radial, int circumferential, int axial);

/// A triangulated surface; triangles by the right-hand rule, normals outward (or along +z).
struct TriangulatedSurface {
  std::vector<Eigen::Vector3d> places;  ///< of the vertices [m]
  std::vector<Triangle> triangles;      ///< indices of places
};

/// The icosahedron with each triangle split into four `level` times: 10 4^level + 2 points on the
/// sphere. Level 6 has 40962 points and 81920 triangles.
TriangulatedSurface icosphere(const Eigen::Vector3d& center, double radius, int level);

/// A flat sheet of count_u x count_v points spanned by two edges from a corner.
TriangulatedSurface sheet(const Eigen::Vector3d& corner, const Eigen::Vector3d& edge_u,
                          const Eigen::Vector3d& edge_v, int count_u, int count_v);

/// A flat disc across an axis (0, 1 or 2), its normal along it: `rings` rings of 6, 12, 18, ...
/// points around the centre, evenly spaced.
TriangulatedSurface disc(const Eigen::Vector3d& center, int axis, double radius, int rings);

/// The same surface with its points numbered brick by brick and cell by cell of the grid, and its
/// triangles by their lowest point: what lies side by side in space lies so in memory.
TriangulatedSurface in_walking_order(const TriangulatedSurface& surface,
                                     const BackgroundGrid& grid);

}  // namespace zona::mpm
