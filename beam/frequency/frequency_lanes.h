#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <vector>

#include "beam/system/beam_system.h"
#include "beam/system/relaxation.h"

/// Solution of a beam's equations at four frequencies at once, for `transfer_function.cc` and
/// `transfer_sensitivity.cc` only. Everything is inlined into functions that are compiled for
/// several instruction sets.
namespace zona::beam::lanes {

using Complex = std::complex<double>;

constexpr int lane_count = 4;
/// Four numbers in one register of AVX2. Eight would fill one of AVX-512, but on other processors
/// the compiler moves them through memory, six times as slowly. The alignment is explicit, because
/// without AVX the compiler chooses less than code compiled with AVX requires.
constexpr std::size_t lane_bytes = lane_count * sizeof(double);
using Lane = double __attribute__((vector_size(lane_bytes), aligned(lane_bytes)));

/// Four complex numbers.
struct alignas(lane_bytes) Complexes {
  Lane re{};
  Lane im{};
};

inline void add(Complexes& sum, double factor, const Complexes& other) {
  sum.re += factor * other.re;
  sum.im += factor * other.im;
}

/// sum -= a b.
inline void subtract_product(Complexes& sum, const Complexes& a, const Complexes& b) {
  sum.re -= a.re * b.re - a.im * b.im;
  sum.im -= a.re * b.im + a.im * b.re;
}

inline void multiply(Complexes& a, const Complexes& b) {
  const Lane re = a.re * b.re - a.im * b.im;
  a.im = a.re * b.im + a.im * b.re;
  a.re = re;
}

inline void invert(Complexes& a) {
  const Lane scale = 1. / (a.re * a.re + a.im * a.im);
  a.re *= scale;
  a.im *= -scale;
}

/// Factors of the system's matrices in the equations at four values of s.
struct Factors {
  Complexes stiffness;
  Complexes mass;                ///< of the structure, with Rayleigh damping
  Complexes support;             ///< of the structure's support mass
  Complexes displaced;           ///< of the displaced liquid
  std::vector<Complexes> share;  ///< of the viscous loads
};

inline void set(Complexes& lanes, int lane, Complex value) {
  lanes.re[lane] = value.real();
  lanes.im[lane] = value.imag();
}

/// Viscous load, as force per length and velocity [Pa s].
inline Complex load_at(const ViscousLoad& load, Complex s) {
  if (load.model == BathModel::frequency)
    return viscous_load(load.flow, load.liquid, load.radius, s);
  const double omega = load.angular_frequency;
  const Complex value = viscous_load(load.flow, load.liquid, load.radius, {0, omega});
  return value.real() + s * value.imag() / omega;
}

inline Factors factors_at(const BeamSystem& system, const Complex* s) {
  Factors factors;
  const std::vector<ViscousLoad>& loads = system.liquids.viscous;
  factors.share.resize(loads.size());
  for (int lane = 0; lane < lane_count; ++lane) {
    const Complex at = s[lane];
    const Complex modulus = system.loss_factor > 0
                                ? loss_modulus(at, system.loss_factor, system.loss_frequency)
                                : Complex(1);
    set(factors.stiffness, lane, modulus + at * system.damping_beta);
    set(factors.mass, lane, at * (at + system.damping_alpha));
    set(factors.support, lane, at * at);
    set(factors.displaced, lane, at * at);
    for (std::size_t k = 0; k < loads.size(); ++k)
      set(factors.share[k], lane, at * load_at(loads[k], at));
  }
  return factors;
}

/// A x = b with A = L D L^T, both row by row.
class BandSolve {
 public:
  explicit BandSolve(int size) : rows_(size) {}

  void set_row(int i, std::array<Complexes, half_bandwidth + 1>& diagonals,
               const Complexes& right_side);
  /// Replaces the right sides by the solution, from the last row back.
  void substitute_back();
  /// Solves for another right side and replaces it by the solution.
  void solve_again(std::vector<Complexes>& right_side) const;
  const Complexes& solution(int i) const { return rows_[i].value; }

 private:
  struct Row {
    Complexes inverse;                            ///< 1 / D
    std::array<Complexes, half_bandwidth> lower;  ///< L(i, i - 1), L(i, i - 2), L(i, i - 3)
    Complexes value;
  };
  std::vector<Row> rows_;
};

inline void BandSolve::set_row(int i, std::array<Complexes, half_bandwidth + 1>& diagonals,
                               const Complexes& right_side) {
  Row& row = rows_[i];
  const int reach = std::min(i, half_bandwidth);
  // Row i of L D, from its farthest entry to the diagonal.
  for (int k = reach; k >= 1; --k)
    for (int m = k + 1; m <= reach; ++m)
      subtract_product(diagonals[k], diagonals[m], rows_[i - k].lower[m - k - 1]);
  row.inverse = diagonals[0];
  row.value = right_side;
  for (int k = 1; k <= reach; ++k) {
    Complexes& lower = row.lower[k - 1];
    lower = diagonals[k];
    multiply(lower, rows_[i - k].inverse);
    subtract_product(row.inverse, diagonals[k], lower);
    subtract_product(row.value, lower, rows_[i - k].value);
  }
  invert(row.inverse);
}

inline void BandSolve::substitute_back() {
  for (Row& row : rows_) multiply(row.value, row.inverse);
  for (int i = static_cast<int>(rows_.size()) - 1; i >= 0; --i)
    for (int k = 1; k <= std::min(i, half_bandwidth); ++k)
      subtract_product(rows_[i - k].value, rows_[i].lower[k - 1], rows_[i].value);
}

inline void BandSolve::solve_again(std::vector<Complexes>& right_side) const {
  const int n = static_cast<int>(rows_.size());
  for (int i = 0; i < n; ++i)
    for (int k = 1; k <= std::min(i, half_bandwidth); ++k)
      subtract_product(right_side[i], rows_[i].lower[k - 1], right_side[i - k]);
  for (int i = 0; i < n; ++i) multiply(right_side[i], rows_[i].inverse);
  for (int i = n - 1; i >= 0; --i)
    for (int k = 1; k <= std::min(i, half_bandwidth); ++k)
      subtract_product(right_side[i - k], rows_[i].lower[k - 1], right_side[i]);
}

/// Entry (i, i - k) of the equations' matrix.
inline Complexes matrix_entry(const BeamSystem& system, const Factors& factors, int i, int k) {
  const LiquidLoads& liquids = system.liquids;
  Complexes entry{};
  add(entry, system.stiffness.diagonal(k)(i), factors.stiffness);
  add(entry, system.mass.diagonal(k)(i), factors.mass);
  if (!liquids.act()) return entry;
  add(entry, liquids.displaced.matrix.diagonal(k)(i), factors.displaced);
  for (std::size_t n = 0; n < liquids.viscous.size(); ++n)
    add(entry, liquids.viscous[n].share.matrix.diagonal(k)(i), factors.share[n]);
  return entry;
}

/// Minus entry i of the right side: the load by unit motion of the support.
inline Complexes support_entry(const BeamSystem& system, const Factors& factors, int i) {
  const LiquidLoads& liquids = system.liquids;
  Complexes entry{};
  add(entry, system.support_mass(i), factors.support);
  if (!liquids.act()) return entry;
  add(entry, liquids.displaced.support(i), factors.displaced);
  for (std::size_t n = 0; n < liquids.viscous.size(); ++n)
    add(entry, liquids.viscous[n].share.support(i), factors.share[n]);
  return entry;
}

/// Factorises the equations and solves them for unit motion of the support.
inline void solve_relative(const BeamSystem& system, const Factors& factors, BandSolve& band) {
  for (int i = 0; i < system.size(); ++i) {
    std::array<Complexes, half_bandwidth + 1> diagonals;
    for (int k = 0; k <= half_bandwidth; ++k) diagonals[k] = matrix_entry(system, factors, i, k);
    Complexes right_side{};
    add(right_side, -1, support_entry(system, factors, i));
    band.set_row(i, diagonals, right_side);
  }
  band.substitute_back();
}

/// Absolute motion of the observed point for unit motion of the support; `band` then holds factors
/// and solution. Compiled for several instruction sets; the loader chooses the best.
void solve(const BeamSystem& system, const Factors& factors, BandSolve& band, Complexes& observed);

}  // namespace zona::beam::lanes
