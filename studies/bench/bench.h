#pragma once

#include <string>
#include <vector>

namespace zona::studies::bench {

/// `zona bench`.
struct BenchOptions {
  std::vector<std::string> scenes;  ///< empty: those of every day
  double seconds = 3;               ///< of stepping, per scene and number of threads
  int threads = 0;                  ///< 0: all
  bool list = false;
  bool json = false;
  bool beam = false;  ///< the integrators of the beam instead of scenes
};

/// Steps through the scenes with one and with all threads and prints where the time goes and what
/// the memory would allow. Throws InputError for a scene that is not there.
int run_bench(const BenchOptions& options);

}  // namespace zona::studies::bench
