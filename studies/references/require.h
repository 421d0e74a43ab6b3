#pragma once

#include <cmath>
#include <string>

#include "mpm/points/errors.h"

namespace zona::studies::references {

/// Throws mpm::ModelError with the message unless the condition holds.
inline void require(bool condition, const std::string& message) {
  if (!condition) throw mpm::ModelError(message);
}

/// Throws mpm::ModelError that names the quantity and its value unless it is finite and positive.
inline void require_positive(double value, const std::string& name) {
  require(std::isfinite(value) && value > 0,
          "the reference needs a positive " + name + ", not " + std::to_string(value));
}

}  // namespace zona::studies::references
