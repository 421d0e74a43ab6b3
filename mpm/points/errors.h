#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

namespace zona::mpm {

/// A model that cannot be computed; thrown before the first step.
class ModelError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A step that cannot be completed.
class StepError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A material point that left the grid or has an invalid state, found during a step.
class PointError : public StepError {
 public:
  /// Composes the text from the event, the body, the point's id, its position [m], the step and the
  /// time [s].
  PointError(const std::string& what_happened, const std::string& body, int point,
             const Eigen::Vector3d& position, long step, double time);
};

}  // namespace zona::mpm
