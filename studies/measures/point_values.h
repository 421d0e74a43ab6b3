#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "mpm/bodies/body.h"
#include "studies/run/columns.h"

namespace zona::studies {

/// A quantity that can be measured at a material point, and its place in `PointValues`.
struct PointQuantity {
  /// Bodies whose points have it: all, those that deform, membranes, or those whose law knows
  /// failure or plastic flow.
  enum class Of { all, deformable, membranes, failing, plastic };

  std::string name;  ///< as in a study file
  std::string unit;
  std::vector<std::string> components;  ///< "xx", ...; a scalar has one empty name
  std::size_t first;                    ///< in PointValues::value
  bool by_volume;                       ///< means are weighted with the volume, not with the mass
  Of of;
};

/// Position, displacement, velocity, stress (xx yy zz xy yz zx), equivalent_stress (von Mises),
/// pressure (-tr sigma / 3), density, strain (largest principal one of a membrane), energy
/// (specific: internal of a fluid, elastic of a solid or membrane), plastic_strain (path length of
/// the plastic strain (5.15)), damage (1 = failed).
const std::vector<PointQuantity>& point_quantities();
/// Throws std::logic_error for an unknown name.
const PointQuantity& point_quantity(const std::string& name);

/// All quantities of a point, or their means over several points, in SI; zero where a material has
/// none.
struct PointValues {
  static constexpr std::size_t count = 22;
  std::array<double, count> value{};
  double mass = 0;    ///< [kg]
  double volume = 0;  ///< [m^3]
};

/// Values at the point that is stored at `p` and started at `start` [m].
PointValues values_at(const mpm::Body& body, int p, const Eigen::Vector3d& start);

/// Mean over points. Add them in the order of their ids, so that sums do not depend on the storage.
class PointMean {
 public:
  void add(const PointValues& point);
  /// NaN everywhere when no point was added.
  PointValues mean() const;
  long points() const { return points_; }

 private:
  PointValues sum_;
  long points_ = 0;
};

/// Columns of a quantity, each name after a prefix: "probe.p.stress_xx".
std::vector<Column> columns_of(const PointQuantity& quantity, const std::string& prefix);

}  // namespace zona::studies
