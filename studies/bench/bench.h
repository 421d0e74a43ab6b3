#pragma once

#include <string>
#include <vector>

namespace zona::studies::bench {

/// `zona bench`.
struct BenchOptions {
  std::vector<std::string> scenes;  ///< empty: the default ones
  double seconds = 3;               ///< per scene and number of threads
  int threads = 0;                  ///< 0: all
  bool list = false;
  bool json = false;
  bool beam = false;  ///< the integrators of the beam instead of scenes
};

/// Runs the scenes with one and with all threads; prints the time of each stage and the bound set
/// by the memory. Throws InputError for an unknown scene.
int run_bench(const BenchOptions& options);

}  // namespace zona::studies::bench
