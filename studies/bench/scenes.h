#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mpm/step/solver.h"

namespace zona::studies::bench {

/// Something to step through.
struct Scene {
  std::string name;
  std::string description;
  bool by_default;  ///< without being asked for by name
  std::function<mpm::Model()> make;
};

const std::vector<Scene>& scenes();

}  // namespace zona::studies::bench
