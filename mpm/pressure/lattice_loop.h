#pragma once

#include <algorithm>
#include <vector>

#include "mpm/grid/cell_lattice.h"
#include "mpm/points/lanes.h"

namespace zona::mpm {

/// One number of single precision per place of a lattice.
using FloatField = std::vector<float, AlignedAllocator<float>>;

/// Places [begin, end) of a lattice.
struct Chunk {
  long number;  ///< among all chunks
  long begin;   ///< first place
  long end;     ///< one after the last place
};

/// Loops over the places of a lattice in chunks, to be called by all threads of a parallel region,
/// or outside of one. Sums and maxima are those of the chunks in their order, for any number of
/// threads.
class LatticeLoop {
 public:
  static constexpr long chunk_length = 256;  ///< places of a chunk, but for the last
  /// For all cells and nodes.
  explicit LatticeLoop(const CellLattice& lattice)
      : first_(lattice.first), last_(lattice.last), partial_{Partial(count()), Partial(count())} {}

  long count() const { return (last_ - first_ + chunk_length - 1) / chunk_length; }  ///< of chunks
  /// Number of the chunk with a place; the nearest one for places outside.
  long chunk_of(long place) const {
    return std::clamp((place - first_) / chunk_length, 0l, count() - 1);
  }
  /// Calls f(Chunk) for each chunk; waits for all.
  template <class F>
  void each(F f) const {
    const long chunks = count();
#pragma omp for schedule(static)
    for (long c = 0; c < chunks; ++c) f(chunk(c));
  }
  /// Sums of f(Chunk), an array of two; every thread gets it. A slot, 0 or 1, must not
  /// be used twice without another loop in between: threads may still be adding.
  template <class F>
  std::array<double, 2> sums(int slot, F f) {
    std::array<double, 2> total{};
    for (const auto& part : store(slot, f)) {
      total[0] += part[0];
      total[1] += part[1];
    }
    return total;
  }
  /// Sum of f(Chunk), a number, likewise.
  template <class F>
  double sum(int slot, F f) {
    return sums(slot, [&](const Chunk& chunk) { return std::array<double, 2>{f(chunk), 0}; })[0];
  }
  /// Maximum of f(Chunk), not below zero, likewise.
  template <class F>
  double maximum(int slot, F f) {
    double most = 0;
    for (const auto& part : store(slot, [&](const Chunk& chunk) {
           return std::array<double, 2>{f(chunk), 0};
         }))
      most = std::max(most, part[0]);
    return most;
  }

 private:
  Chunk chunk(long c) const {
    const long begin = first_ + c * chunk_length;
    return {c, begin, std::min(last_, begin + chunk_length)};
  }
  using Partial = std::vector<std::array<double, 2>>;

  template <class F>
  const Partial& store(int slot, F f) {
    const long chunks = count();
    Partial& partial = partial_[slot];
#pragma omp for schedule(static)
    for (long c = 0; c < chunks; ++c) partial[c] = f(chunk(c));
    return partial;
  }

  long first_;
  long last_;
  std::array<Partial, 2> partial_;  ///< of the chunks
};

}  // namespace zona::mpm
