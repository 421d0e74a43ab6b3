#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

namespace zona::beam {

/// Throws std::invalid_argument with the message unless the condition holds.
inline void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

/// True for finite values above zero.
inline bool is_positive(double value) {
  return std::isfinite(value) && value > 0;
}
/// True for finite values not below zero.
inline bool is_non_negative(double value) {
  return std::isfinite(value) && value >= 0;
}

}  // namespace zona::beam
