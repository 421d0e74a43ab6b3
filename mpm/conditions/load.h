#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mpm/bodies/body.h"
#include "mpm/grid/region.h"

namespace zona::mpm {

/// A force [N] on those points of a body that lie in `region` at the start, shared by mass. The
/// same points carry it wherever they move.
struct BodyForce {
  std::string body;  ///< its name
  Box region;        ///< of the points at the start [m]
  /// Total on all these points [N], of time [s].
  std::function<Eigen::Vector3d(double time)> force;
};

/// A pressure [Pa] on the intact triangles of a membrane, along their present normals: positive
/// outwards. A third of a triangle's force goes to each of its vertices.
struct SurfacePressure {
  std::string body;                             ///< name of a membrane
  std::function<double(double time)> pressure;  ///< [Pa], of time [s]
};

/// The loads of a model. They act on points and reach the nodes through the shape functions, which
/// is (5.51) with the surface integral as a sum over points.
class Loads {
 public:
  /// Throws ModelError for a body that is not there, moves as prescribed or has no point in the
  /// region, for a pressure on what is no membrane, and for a load without a value.
  Loads(const std::vector<BodyForce>& forces, const std::vector<SurfacePressure>& pressures,
        const std::vector<Body>& bodies);

  bool empty() const { return forces_.empty() && pressures_.empty(); }  ///< nothing acts
  /// Takes the loads at `time` [s], to be added by the calls of `add_brick` that follow.
  void evaluate(double time);
  /// Adds the forces on the points of one brick to the force of its nodes [N].
  void add_brick(const std::vector<Body>& bodies, int b, BackgroundGrid& grid) const;

 private:
  struct SharedForce {
    std::size_t body;
    std::vector<double> share;  ///< of each point, by id
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
