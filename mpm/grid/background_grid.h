#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mpm/points/lanes.h"

namespace zona::mpm {

/// Boundary condition on a face of the grid.
enum class FaceCondition {
  free,       ///< no traction
  roller,     ///< normal velocity held at zero
  fixed,      ///< velocity held at zero
  absorbing,  ///< viscous tractions absorb outgoing waves (5.43)-(5.55)
};

/// Conditions on the six faces: x low, x high, y low, y high, z low, z high.
using FaceConditions = std::array<FaceCondition, 6>;

/// Shape functions of the grid.
enum class Interpolation {
  linear,    ///< trilinear, eight nodes per cell, as in the source
  quadratic  ///< quadratic B-splines, 27 nodes per cell: the gradient is continuous between cells
};

/// A cuboid of up to `edge`^3 cells, the unit of work of one thread. Bricks of one colour share no
/// node, so threads scatter to the grid without atomics, and the order of every sum is fixed.
struct Brick {
  static constexpr int edge = 4;                         ///< greatest number of cells along an edge
  static constexpr int cell_count = edge * edge * edge;  ///< of a full brick
  std::array<int, 3> first_cell;                         ///< lowest cell indices
  std::array<int, 3> size;                               ///< cells along each axis, at most `edge`
};

/// Lighter nodes [kg] are not solved (section 3.2).
inline constexpr double smallest_nodal_mass = 1e-30;

/// The Eulerian background grid of section 3.2: cuboid cells and the nodes of their shape
/// functions.
///
/// A node holds eight numbers, one cache line: mass, momentum (3), force (3), mass times wave
/// speed. After the momentum is advanced they are mass, velocity at k+1 (3), acceleration (3).
///
/// Linear: node n of a cell lies at the corner whose x, y, z offsets are the bits 0, 1, 2 of n.
/// Quadratic: node n of a cell has the offsets n % 3, n / 3 % 3, n / 9, so an axis has two more
/// nodes than cells. Nodes stand for B-splines; their positions are the Greville points, i.e. the
/// centres of the cells and the faces of the grid.
class BackgroundGrid {
 public:
  /// `origin` is the lowest corner [m], `cell_size` the cell's edges [m]. Throws ModelError for an
  /// empty grid or a cell size that is not positive.
  BackgroundGrid(const Eigen::Vector3d& origin, const Eigen::Vector3d& cell_size,
                 const std::array<int, 3>& cells,
                 Interpolation interpolation = Interpolation::linear);

  const Eigen::Vector3d& origin() const { return origin_; }               ///< lowest corner [m]
  const Eigen::Vector3d& cell_size() const { return cell_size_; }         ///< edges of a cell [m]
  const std::array<int, 3>& cells() const { return cells_; }              ///< along each axis
  Interpolation interpolation() const { return interpolation_; }          ///< shape functions
  const std::array<int, 3>& nodes_along() const { return nodes_along_; }  ///< along each axis
  Eigen::Vector3d upper_corner() const;                                   ///< [m]
  double cell_volume() const { return cell_size_.prod(); }                ///< [m^3]
  const std::array<double, 3>& inverse_cell_size() const { return inverse_cell_size_; }  ///< [1/m]
  /// Characteristic length of a cell [m] (4.46).
  double characteristic_length() const { return characteristic_length_; }
  /// Length of `state` and of `updated`.
  std::size_t node_count() const { return state.size(); }

  /// All bricks, x fastest, then y.
  const std::vector<Brick>& bricks() const { return bricks_; }
  /// Bricks that share no node with one another, for each of the eight colours.
  const std::array<std::vector<int>, 8>& bricks_by_colour() const { return by_colour_; }

  /// Indices of the cell that contains a place [m]; negative if the place lies outside or is not
  /// finite.
  std::array<int, 3> cell_at(double x, double y, double z) const;
  /// The brick that contains the cell with these indices.
  int brick_of(const std::array<int, 3>& cell) const;
  /// Number of a cell within its brick: x fastest, then y, `Brick::edge` along each axis.
  static int cell_in_brick(const std::array<int, 3>& cell);

  /// Index of a node in `state` and `updated`: x fastest, then y.
  int node_index(int i, int j, int k) const {
    return (k * nodes_along_[1] + j) * nodes_along_[0] + i;
  }
  /// Position of a node [m]. Nodal values that are linear in it are interpolated exactly.
  Eigen::Vector3d node_position(int i, int j, int k) const;
  /// The same by the node's index in `state`.
  Eigen::Vector3d node_position(int node) const {
    const int layer = nodes_along_[0] * nodes_along_[1];
    return node_position(node % nodes_along_[0], node % layer / nodes_along_[0], node / layer);
  }
  /// 8 or 27.
  int nodes_per_cell() const { return interpolation_ == Interpolation::quadratic ? 27 : 8; }
  /// Offsets of a cell's `nodes_per_cell` nodes from its lowest one.
  const std::array<int, 27>& node_offsets() const { return node_offsets_; }

  std::vector<Lanes, AlignedAllocator<Lanes>> state;  ///< per node, see above
  /// Momentum, then velocity, mapped back from the points (3.38)-(3.39), per node; [3]: mass times
  /// shear wave speed.
  std::vector<HalfLanes, AlignedAllocator<HalfLanes>> updated;

 private:
  Eigen::Vector3d origin_;
  Eigen::Vector3d cell_size_;
  std::array<double, 3> inverse_cell_size_;  ///< [1/m]
  double characteristic_length_;
  std::array<int, 3> cells_;
  Interpolation interpolation_;
  std::array<int, 3> nodes_along_;
  std::array<int, 3> bricks_along_;
  std::array<int, 27> node_offsets_{};
  std::vector<Brick> bricks_;
  std::array<std::vector<int>, 8> by_colour_;
};

}  // namespace zona::mpm
