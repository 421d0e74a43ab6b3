#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

namespace zona::mpm {

/// A model that cannot be computed as it was set up: refused before the first step.
class ModelError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A material point that went wrong during a step: it left the grid, or its state lost its meaning.
class PointError : public std::runtime_error {
 public:
  /// Puts the text together: what happened to which point (its id) of which body, at which position
  /// [m], in which step and at which time [s].
  PointError(const std::string& what_happened, const std::string& body, int point,
             const Eigen::Vector3d& position, long step, double time);
};

}  // namespace zona::mpm
