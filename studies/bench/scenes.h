#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mpm/step/solver.h"

namespace zona::studies::bench {

/// A model for benchmarks.
struct Scene {
  std::string name;
  std::string description;
  bool by_default;  ///< without being named
  std::function<mpm::Model()> make;
  double step = 0;  ///< [s]; 0: a part of the critical one
};

const std::vector<Scene>& scenes();

}  // namespace zona::studies::bench
