#include "studies/bench/stream.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>

namespace zona::studies::bench {

double stream_triad(int threads) {
  constexpr long count = 1L << 24;
  constexpr int sweeps = 8;
  // Not a vector: the pages must first be touched by the threads that use them.
  const std::unique_ptr<double[]> a(new double[count]), b(new double[count]), c(new double[count]);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (long i = 0; i < count; ++i) {
    a[i] = 0;
    b[i] = 1;
    c[i] = 2;
  }
  double best = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const auto start = std::chrono::steady_clock::now();
#pragma omp parallel for num_threads(threads) schedule(static)
    for (long i = 0; i < count; ++i) a[i] = b[i] + 3.0 * c[i];
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    best = std::min(best, seconds.count());
  }
  return 3.0 * sizeof(double) * count / best;
}

}  // namespace zona::studies::bench
