#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "mpm/grid/background_grid.h"
#include "mpm/membranes/surface.h"

namespace zona::mpm {

/// Positions of points and the volume [m^3] that each represents.
struct Lattice {
  std::vector<Eigen::Vector3d> places;  ///< [m]
  std::vector<double> volumes;          ///< [m^3], one per place

  /// Adds a point.
  void add(const Eigen::Vector3d& place, double volume) {
    places.push_back(place);
    volumes.push_back(volume);
  }
  double volume() const;  ///< of all points [m^3]
};

/// A regular lattice with `per_cell` points along each axis in every cell of the grid, limited to
/// the places [m] for which `inside` returns true.
Lattice fill_cells(const BackgroundGrid& grid, const std::array<int, 3>& per_cell,
                   const std::function<bool(const Eigen::Vector3d&)>& inside);

/// A box from `low` to `high` [m] with `count` points along each axis, independent of the grid.
Lattice box(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
            const std::array<int, 3>& count);

/// A straight tube: a hollow cylinder.
struct Tube {
  Eigen::Vector3d end;   ///< centre of the end at which the axis starts [m]
  Eigen::Vector3d axis;  ///< unit vector from that end into the tube
  double length;         ///< [m]
  double inner_radius;   ///< [m]
  double outer_radius;   ///< [m]
};

/// Points at the centres of `radial` x `circumferential` x `axial` equal divisions of a tube's
/// wall.
Lattice tube(const Tube& tube, int radial, int circumferential, int axial);

/// A triangulated surface; by the right-hand rule its normals point outward (or along +z).
struct TriangulatedSurface {
  std::vector<Eigen::Vector3d> places;  ///< of the vertices [m]
  std::vector<Triangle> triangles;      ///< indices of places
};

/// A sphere [m] from an icosahedron, each triangle split into four `level` times: 10 4^level + 2
/// points. Level 6 has 40962 points and 81920 triangles.
TriangulatedSurface icosphere(const Eigen::Vector3d& center, double radius, int level);

/// A flat sheet of count_u x count_v points, spanned by two edges [m] from a corner.
TriangulatedSurface sheet(const Eigen::Vector3d& corner, const Eigen::Vector3d& edge_u,
                          const Eigen::Vector3d& edge_v, int count_u, int count_v);

/// A flat disc with its normal along an axis (0, 1 or 2): `rings` evenly spaced rings of 6, 12, 18,
/// ... points around the centre.
TriangulatedSurface disc(const Eigen::Vector3d& center, int axis, double radius, int rings);

/// The same surface with its points sorted by brick and cell of the grid and its triangles by their
/// lowest point, so that neighbours in space are neighbours in memory.
TriangulatedSurface in_traversal_order(const TriangulatedSurface& surface,
                                       const BackgroundGrid& grid);

}  // namespace zona::mpm
