#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mpm/bodies/body.h"
#include "mpm/grid/region.h"

namespace zona::mpm {

/// A force on the points of a body that lie in `region` at the start, distributed by mass. It stays
/// on these points as they move.
struct BodyForce {
  std::string body;  ///< name of the body
  Box region;        ///< contains the points at the start [m]
  /// Total force on these points [N] as a function of time [s].
  std::function<Eigen::Vector3d(double time)> force;
};

/// A pressure on the intact triangles of a membrane, along their current normals and positive
/// outwards. Each vertex gets a third of a triangle's force.
struct SurfacePressure {
  std::string body;                             ///< name of a membrane
  std::function<double(double time)> pressure;  ///< [Pa] as a function of time [s]
};

/// The loads of a model. They act on points and reach the nodes through the shape functions: (5.51)
/// with the surface integral as a sum over points.
class Loads {
 public:
  /// Throws ModelError for a body that does not exist, has a prescribed motion or has no points in
  /// the region, for a pressure on a body that is no membrane, and for a load without a value.
  Loads(const std::vector<BodyForce>& forces, const std::vector<SurfacePressure>& pressures,
        const std::vector<Body>& bodies);

  bool empty() const { return forces_.empty() && pressures_.empty(); }  ///< true without loads
  /// Evaluates the loads at `time` [s], for the following calls of `add_brick`.
  void evaluate(double time);
  /// Adds the forces on the points of one brick to the force of its nodes [N].
  void add_brick(const std::vector<Body>& bodies, int b, BackgroundGrid& grid) const;

 private:
  struct SharedForce {
    std::size_t body;
    std::vector<double> share;  ///< per point, by id
    std::function<Eigen::Vector3d(double)> at;
    Eigen::Vector3d now;
  };
  struct Pressure {
    std::size_t body;
    std::function<double(double)> at;
    double now;
  };
  std::vector<SharedForce> forces_;
  std::vector<Pressure> pressures_;
};

}  // namespace zona::mpm
