#pragma once

#include <cmath>
#include <cstddef>
#include <new>
#include <vector>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace zona::mpm {

/// Eight doubles that are computed together: the eight nodes of a cell, the eight fields of a node,
/// or eight points of a cell. One AVX-512 register; compilers split it where registers are
/// narrower.
using Lanes = double __attribute__((vector_size(64)));
/// Four doubles: the updated momentum of a node.
using HalfLanes = double __attribute__((vector_size(32)));
/// What a comparison of Lanes gives: -1 where true, 0 where false.
using LaneMask = decltype(Lanes{} < Lanes{});

inline constexpr int lane_count = 8;

inline Lanes broadcast(double value) {
  return Lanes{} + value;
}

inline Lanes load(const double* source) {
  Lanes lanes;
  __builtin_memcpy(&lanes, source, sizeof(Lanes));
  return lanes;
}

inline void store(double* target, const Lanes& lanes) {
  __builtin_memcpy(target, &lanes, sizeof(Lanes));
}

/// The first `count` lanes from memory, the first of them in the others too; `count` is at least 1.
inline Lanes load_first(const double* source, int count) {
#ifdef __AVX512F__
  return _mm512_mask_loadu_pd(_mm512_set1_pd(*source), static_cast<__mmask8>((1u << count) - 1),
                              source);
#else
  Lanes lanes;
  for (int l = 0; l < lane_count; ++l) lanes[l] = source[l < count ? l : 0];
  return lanes;
#endif
}

inline void store_first(double* target, const Lanes& lanes, int count) {
#ifdef __AVX512F__
  _mm512_mask_storeu_pd(target, static_cast<__mmask8>((1u << count) - 1), lanes);
#else
  for (int l = 0; l < count; ++l) target[l] = lanes[l];
#endif
}

/// source[index[l]] in each lane.
inline Lanes gather(const double* source, const int* index) {
  return Lanes{source[index[0]], source[index[1]], source[index[2]], source[index[3]],
               source[index[4]], source[index[5]], source[index[6]], source[index[7]]};
}

inline Lanes square_root(const Lanes& a) {
  Lanes result;
  for (int l = 0; l < lane_count; ++l) result[l] = std::sqrt(a[l]);
  return result;
}

inline double square_root(double a) {
  return std::sqrt(a);
}

inline Lanes larger(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}

inline double larger(double a, double b) {
  return a > b ? a : b;
}

/// Whether any of the first `count` lanes is set.
inline bool any(const LaneMask& mask, int count = lane_count) {
  long long set = 0;
  for (int l = 0; l < lane_count; ++l) set |= l < count ? mask[l] : 0;
  return set != 0;
}

/// rows[f][n] -> rows[n][f]: from a field's eight nodes to a node's eight fields.
inline void transpose(Lanes (&rows)[8]) {
  Lanes t[8];
  Lanes u[8];
  for (int pair = 0; pair < 8; pair += 2) {
    t[pair] = __builtin_shufflevector(rows[pair], rows[pair + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    t[pair + 1] = __builtin_shufflevector(rows[pair], rows[pair + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int half = 0; half < 8; half += 4) {
    for (int odd = 0; odd < 2; ++odd) {
      const Lanes& a = t[half + odd];
      const Lanes& b = t[half + odd + 2];
      u[half + odd] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
      u[half + odd + 2] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (int n = 0; n < 4; ++n) {
    rows[n] = __builtin_shufflevector(u[n], u[n + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    rows[n + 4] = __builtin_shufflevector(u[n], u[n + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

/// Allocates at cache-line boundaries.
template <class T>
struct AlignedAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
  bool operator==(const AlignedAllocator&) const { return true; }
  bool operator!=(const AlignedAllocator&) const { return false; }
};

/// One quantity of every point of a body.
using Field = std::vector<double, AlignedAllocator<double>>;

}  // namespace zona::mpm
