#pragma once

#include <cmath>
#include <cstddef>
#include <new>
#include <vector>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace zona::mpm {

/// Four doubles: the updated momentum of a node.
using HalfLanes = double __attribute__((vector_size(32)));

inline constexpr int lane_count = 8;  ///< numbers computed together

// Lanes and LaneMask consist of one AVX-512 register, or of two halves. They are classes on all
// processors so that function names do not depend on the instruction set.
#ifdef __AVX512F__
using WholeLanes = double __attribute__((vector_size(64)));
#endif

/// Result of a comparison of Lanes: -1 where true, 0 where false.
class LaneMask {
 public:
  /// Four of the eight.
  using Half = long long __attribute__((vector_size(32)));
#ifdef __AVX512F__
  using Whole = long long __attribute__((vector_size(64)));
  LaneMask() : whole{} {}
  explicit LaneMask(const Whole& w) : whole(w) {}
  long long operator[](int l) const {
    return whole[l];
  }
  friend LaneMask operator&(const LaneMask& a, const LaneMask& b) {
    return LaneMask(a.whole & b.whole);
  }
  friend LaneMask operator|(const LaneMask& a, const LaneMask& b) {
    return LaneMask(a.whole | b.whole);
  }
  LaneMask operator~() const {
    return LaneMask(~whole);
  }

  Whole whole;
#else
  /// All false.
  LaneMask() : low{}, high{} {}
  /// The first and the last four lanes.
  LaneMask(const Half& l, const Half& h) : low(l), high(h) {}
  /// Lane l: -1 or 0.
  long long operator[](int l) const {
    return l < 4 ? low[l] : high[l - 4];
  }
  /// @{
  /// Lane by lane.
  friend LaneMask operator&(const LaneMask& a, const LaneMask& b) {
    return {a.low & b.low, a.high & b.high};
  }
  friend LaneMask operator|(const LaneMask& a, const LaneMask& b) {
    return {a.low | b.low, a.high | b.high};
  }
  LaneMask operator~() const {
    return {~low, ~high};
  }
  /// @}

  Half low;   ///< the first four lanes
  Half high;  ///< the last four lanes
#endif
  /// Lane by lane.
  LaneMask& operator|=(const LaneMask& other) {
    return *this = *this | other;
  }
};

/// Eight doubles that are computed together: the eight nodes of a cell, the eight fields of a node,
/// or eight points of a cell. A single number converts to eight copies.
class alignas(64) Lanes {
 public:
  constexpr Lanes() : Lanes(0.0) {}
#ifdef __AVX512F__
  constexpr Lanes(double s) : whole{s, s, s, s, s, s, s, s} {}
  constexpr Lanes(double a, double b, double c, double d, double e, double f, double g, double h)
      : whole{a, b, c, d, e, f, g, h} {}
  explicit Lanes(const WholeLanes& w) : whole(w) {}
  double operator[](int l) const {
    return whole[l];
  }

  WholeLanes whole;
#else
  /// @{
  /// One number in all lanes, eight numbers, or two halves.
  constexpr Lanes(double s) : low{s, s, s, s}, high{s, s, s, s} {}
  constexpr Lanes(double a, double b, double c, double d, double e, double f, double g, double h)
      : low{a, b, c, d}, high{e, f, g, h} {}
  Lanes(const HalfLanes& l, const HalfLanes& h) : low(l), high(h) {}
  /// @}
  /// Lane l.
  double operator[](int l) const {
    return l < 4 ? low[l] : high[l - 4];
  }

  HalfLanes low;   ///< the first four lanes
  HalfLanes high;  ///< the last four lanes
#endif
  /// Lane l for writing; slow for lanes in registers.
  double& operator[](int l) {
    return reinterpret_cast<double*>(this)[l];
  }

  /// @{
  /// Lane by lane.
  Lanes operator-() const {
    return 0.0 - *this;
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b);
  friend Lanes operator-(const Lanes& a, const Lanes& b);
  friend Lanes operator*(const Lanes& a, const Lanes& b);
  friend Lanes operator/(const Lanes& a, const Lanes& b);
  friend LaneMask operator<(const Lanes& a, const Lanes& b);
  friend LaneMask operator<=(const Lanes& a, const Lanes& b);
  friend LaneMask operator>(const Lanes& a, const Lanes& b);
  friend LaneMask operator>=(const Lanes& a, const Lanes& b);
  friend LaneMask operator==(const Lanes& a, const Lanes& b);
  Lanes& operator+=(const Lanes& b) {
    return *this = *this + b;
  }
  Lanes& operator-=(const Lanes& b) {
    return *this = *this - b;
  }
  Lanes& operator*=(const Lanes& b) {
    return *this = *this * b;
  }
  /// @}
};

#ifdef __AVX512F__
#define ZONA_LANES(type, operation) return type(a.whole operation b.whole)
#else
#define ZONA_LANES(type, operation) return type(a.low operation b.low, a.high operation b.high)
#endif
/// @{
/// Lane by lane.
inline Lanes operator+(const Lanes& a, const Lanes& b) {
  ZONA_LANES(Lanes, +);
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
  ZONA_LANES(Lanes, -);
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
  ZONA_LANES(Lanes, *);
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
  ZONA_LANES(Lanes, /);
}
inline LaneMask operator<(const Lanes& a, const Lanes& b) {
  ZONA_LANES(LaneMask, <);
}
inline LaneMask operator<=(const Lanes& a, const Lanes& b) {
  ZONA_LANES(LaneMask, <=);
}
inline LaneMask operator>(const Lanes& a, const Lanes& b) {
  ZONA_LANES(LaneMask, >);
}
inline LaneMask operator>=(const Lanes& a, const Lanes& b) {
  ZONA_LANES(LaneMask, >=);
}
inline LaneMask operator==(const Lanes& a, const Lanes& b) {
  ZONA_LANES(LaneMask, ==);
}
/// @}
#undef ZONA_LANES

/// One number in all lanes.
inline Lanes broadcast(double value) {
  return Lanes(value);
}

/// @{
/// The first or last four lanes, and the inverse: eight lanes from two halves.
inline HalfLanes low_half(const Lanes& a) {
#ifdef __AVX512F__
  return __builtin_shufflevector(a.whole, a.whole, 0, 1, 2, 3);
#else
  return a.low;
#endif
}
inline HalfLanes high_half(const Lanes& a) {
#ifdef __AVX512F__
  return __builtin_shufflevector(a.whole, a.whole, 4, 5, 6, 7);
#else
  return a.high;
#endif
}
inline Lanes join(const HalfLanes& low, const HalfLanes& high) {
#ifdef __AVX512F__
  return Lanes(__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7));
#else
  return {low, high};
#endif
}
/// @}

/// Eight consecutive numbers, at any address.
inline Lanes load(const double* source) {
#ifdef __AVX512F__
  WholeLanes lanes;
  __builtin_memcpy(&lanes, source, sizeof(lanes));
  return Lanes(lanes);
#else
  HalfLanes low, high;
  __builtin_memcpy(&low, source, sizeof(low));
  __builtin_memcpy(&high, source + 4, sizeof(high));
  return {low, high};
#endif
}

/// Stores all lanes, at any address.
inline void store(double* target, const Lanes& lanes) {
#ifdef __AVX512F__
  __builtin_memcpy(target, &lanes.whole, sizeof(lanes.whole));
#else
  __builtin_memcpy(target, &lanes.low, sizeof(lanes.low));
  __builtin_memcpy(target + 4, &lanes.high, sizeof(lanes.high));
#endif
}

/// Loads the first `count` lanes, at least 1; the other lanes repeat the first number.
inline Lanes load_first(const double* source, int count) {
#ifdef __AVX512F__
  return Lanes(_mm512_mask_loadu_pd(_mm512_set1_pd(*source),
                                    static_cast<__mmask8>((1u << count) - 1), source));
#else
  const auto at = [&](int l) { return source[l < count ? l : 0]; };
  return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
#endif
}

/// Stores the first `count` lanes; `count` is at least 1.
inline void store_first(double* target, const Lanes& lanes, int count) {
#ifdef __AVX512F__
  _mm512_mask_storeu_pd(target, static_cast<__mmask8>((1u << count) - 1), lanes.whole);
#else
  if (count == lane_count) return store(target, lanes);
  for (int l = 0; l < count; ++l) target[l] = lanes[l];
#endif
}

/// source[index[l]] in each lane.
inline Lanes gather(const double* source, const int* index) {
  return Lanes{source[index[0]], source[index[1]], source[index[2]], source[index[3]],
               source[index[4]], source[index[5]], source[index[6]], source[index[7]]};
}

/// f(l) in each lane l.
template <class F>
inline Lanes each_lane(F f) {
  return {f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)};
}

/// Square root of a number; the overload for Lanes lets material laws be templates on both.
inline double square_root(double a) {
  return std::sqrt(a);
}

/// Square root of each lane.
inline Lanes square_root(const Lanes& a) {
  return each_lane([&](int l) { return std::sqrt(a[l]); });
}

/// `a` where true, `b` where false.
inline Lanes select(const LaneMask& mask, const Lanes& a, const Lanes& b) {
#ifdef __AVX512F__
  return Lanes(mask.whole ? a.whole : b.whole);
#else
  return {mask.low ? a.low : b.low, mask.high ? a.high : b.high};
#endif
}

/// The same for numbers.
inline double select(bool condition, double a, double b) {
  return condition ? a : b;
}

/// The larger of two, lane by lane.
inline Lanes larger(const Lanes& a, const Lanes& b) {
  return select(a > b, a, b);
}

/// The same for numbers.
inline double larger(double a, double b) {
  return a > b ? a : b;
}

/// True if any of the first `count` lanes is set.
inline bool any(const LaneMask& mask, int count = lane_count) {
  long long set = 0;
  for (int l = 0; l < lane_count; ++l) set |= l < count ? mask[l] : 0;
  return set != 0;
}

/// rows[f][n] -> rows[n][f]: from eight nodes per field to eight fields per node.
inline void transpose(Lanes (&rows)[8]) {
#ifdef __AVX512F__
  WholeLanes t[8];
  WholeLanes u[8];
  for (int pair = 0; pair < 8; pair += 2) {
    const WholeLanes& a = rows[pair].whole;
    const WholeLanes& b = rows[pair + 1].whole;
    t[pair] = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    t[pair + 1] = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int half = 0; half < 8; half += 4) {
    for (int odd = 0; odd < 2; ++odd) {
      const WholeLanes& a = t[half + odd];
      const WholeLanes& b = t[half + odd + 2];
      u[half + odd] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
      u[half + odd + 2] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (int n = 0; n < 4; ++n) {
    rows[n].whole = __builtin_shufflevector(u[n], u[n + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    rows[n + 4].whole = __builtin_shufflevector(u[n], u[n + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
#else
  const auto transpose_block = [](HalfLanes& a, HalfLanes& b, HalfLanes& c, HalfLanes& d) {
    const HalfLanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const HalfLanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const HalfLanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const HalfLanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
    c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
    d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
  };
  for (int half = 0; half < 8; half += 4) {
    transpose_block(rows[half].low, rows[half + 1].low, rows[half + 2].low, rows[half + 3].low);
    transpose_block(rows[half].high, rows[half + 1].high, rows[half + 2].high, rows[half + 3].high);
  }
  for (int n = 0; n < 4; ++n) {
    const HalfLanes upper_right = rows[n].high;
    rows[n].high = rows[n + 4].low;
    rows[n + 4].low = upper_right;
  }
#endif
}

/// Allocates at cache-line boundaries.
template <class T>
struct AlignedAllocator {
  /// Type of the elements.
  using value_type = T;
  static constexpr std::align_val_t alignment{64};  ///< of a cache line [bytes]
  AlignedAllocator() = default;
  /// Conversion between element types; there is no state to copy.
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  /// @{
  /// Memory for n elements.
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
  /// @}
  /// @{
  /// All allocators are equal.
  bool operator==(const AlignedAllocator&) const { return true; }
  bool operator!=(const AlignedAllocator&) const { return false; }
  /// @}
};

/// One quantity of every point of a body.
using Field = std::vector<double, AlignedAllocator<double>>;

}  // namespace zona::mpm
