#include "beam/transfer_function.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "beam/relaxation.h"
#include "beam/require.h"

namespace zona::beam {
namespace {

using Complex = std::complex<double>;

constexpr double kPi = 3.14159265358979323846;
constexpr int kLanes = 8;
/// Eight numbers that are computed together, in as many registers as the processor needs. The
/// alignment is spelt out, because without AVX-512 the compiler takes less than code with it relies
/// on.
constexpr std::size_t kLaneBytes = kLanes * sizeof(double);
using Lane = double __attribute__((vector_size(kLaneBytes), aligned(kLaneBytes)));

/// Eight complex numbers.
struct alignas(kLaneBytes) Complexes {
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

/// The equations at eight values of s as factors of the system's matrices.
struct Factors {
  Complexes stiffness;
  Complexes mass;                ///< of the structure, Rayleigh damping with it
  Complexes support;             ///< of the structure's support mass
  Complexes displaced;           ///< of the displaced liquid
  std::vector<Complexes> share;  ///< of the bath's nodes
};

void set(Complexes& lanes, int lane, Complex value) {
  lanes.re[lane] = value.real();
  lanes.im[lane] = value.imag();
}

/// Force per length and velocity of the bath at a node, less that of displaced liquid.
Complex bath_load(const Immersion& bath, std::size_t node, Complex s) {
  if (bath.model == BathModel::frequency) return viscous_load(bath.liquid, bath.radius[node], s);
  const double omega = bath.angular_frequency;
  const Complex load = viscous_load(bath.liquid, bath.radius[node], {0, omega});
  return load.real() + s * load.imag() / omega;
}

Factors factors_at(const BeamSystem& system, const Complex* s) {
  Factors factors;
  const Immersion& bath = system.immersion;
  factors.share.resize(bath.radius.size());
  for (int lane = 0; lane < kLanes; ++lane) {
    const Complex at = s[lane];
    const Complex modulus = system.loss_factor > 0
                                ? loss_modulus(at, system.loss_factor, system.loss_frequency)
                                : Complex(1);
    set(factors.stiffness, lane, modulus + at * system.damping_beta);
    set(factors.mass, lane, at * (at + system.damping_alpha));
    set(factors.support, lane, at * at);
    set(factors.displaced, lane, at * at);
    for (std::size_t k = 0; k < bath.radius.size(); ++k)
      set(factors.share[k], lane, at * bath_load(bath, k, at));
  }
  return factors;
}

/// A x = b with A = L D L^T, both row by row.
class BandSolve {
 public:
  explicit BandSolve(int size) : rows_(size) {}

  inline void set_row(int i, std::array<Complexes, kHalfBandwidth + 1>& diagonals,
                      const Complexes& right_side);
  /// Replaces right sides by the solution, from the last row back.
  inline void substitute_back();
  const Complexes& solution(int i) const { return rows_[i].value; }

 private:
  struct Row {
    Complexes inverse;                            ///< 1 / D
    std::array<Complexes, kHalfBandwidth> lower;  ///< L(i, i - 1), L(i, i - 2), L(i, i - 3)
    Complexes value;
  };
  std::vector<Row> rows_;
};

void BandSolve::set_row(int i, std::array<Complexes, kHalfBandwidth + 1>& diagonals,
                        const Complexes& right_side) {
  Row& row = rows_[i];
  const int reach = std::min(i, kHalfBandwidth);
  // Row i of L D, from the farthest entry on.
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

void BandSolve::substitute_back() {
  for (Row& row : rows_) multiply(row.value, row.inverse);
  for (int i = static_cast<int>(rows_.size()) - 1; i >= 0; --i)
    for (int k = 1; k <= std::min(i, kHalfBandwidth); ++k)
      subtract_product(rows_[i - k].value, rows_[i].lower[k - 1], rows_[i].value);
}

/// The observed point's absolute motion for unit motion of the support. Compiled for several
/// instruction sets, of which the loader takes the best.
[[gnu::flatten, gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]] void solve(
    const BeamSystem& system, const Factors& factors, BandSolve& band, Complexes& observed) {
  const Immersion& bath = system.immersion;
  const int n = system.size();
  for (int i = 0; i < n; ++i) {
    std::array<Complexes, kHalfBandwidth + 1> diagonals{};
    for (int k = 0; k <= kHalfBandwidth; ++k) {
      add(diagonals[k], system.stiffness.diagonal(k)(i), factors.stiffness);
      add(diagonals[k], system.mass.diagonal(k)(i), factors.mass);
      if (!bath.acts()) continue;
      add(diagonals[k], bath.displaced.matrix.diagonal(k)(i), factors.displaced);
      for (std::size_t node = 0; node < bath.share.size(); ++node)
        add(diagonals[k], bath.share[node].matrix.diagonal(k)(i), factors.share[node]);
    }
    Complexes right_side{};
    add(right_side, -system.support_mass(i), factors.support);
    if (bath.acts()) {
      add(right_side, -bath.displaced.support(i), factors.displaced);
      for (std::size_t node = 0; node < bath.share.size(); ++node)
        add(right_side, -bath.share[node].support(i), factors.share[node]);
    }
    band.set_row(i, diagonals, right_side);
  }
  band.substitute_back();
  observed = Complexes{};
  observed.re += system.support_share;
  for (int i = 0; i < n; ++i)
    if (system.observation(i) != 0) add(observed, system.observation(i), band.solution(i));
}

/// How fast the transform's line of s makes signals die out, times the time of the inversion.
constexpr double kDamping = 30;

int inversion_length(const Sampling& sampling) {
  int length = 2;
  while (length < 2 * sample_count(sampling)) length *= 2;
  return length;
}

}  // namespace

TransferFunction::TransferFunction(const BeamSystem& system) : system_(system) {
  const Immersion& bath = system.immersion;
  require(!bath.acts() || (bath.model != BathModel::per_mode && bath.drag.empty()),
          "transform: it takes no quadratic drag and no bath of the model per_mode; choose another "
          "integrator");
}

Complex TransferFunction::operator()(Complex s) const {
  return at({s}).front();
}

std::vector<Complex> TransferFunction::at(const std::vector<Complex>& s) const {
  std::vector<Complex> values(s.size());
  BandSolve band(system_.size());
  for (std::size_t first = 0; first < s.size(); first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, s.size() - first);
    std::array<Complex, kLanes> lanes;
    for (int lane = 0; lane < kLanes; ++lane)
      lanes[lane] = s[first + std::min<std::size_t>(lane, count - 1)];
    Complexes observed;
    solve(system_, factors_at(system_, lanes.data()), band, observed);
    for (std::size_t lane = 0; lane < count; ++lane)
      values[first + lane] = {observed.re[lane], observed.im[lane]};
  }
  return values;
}

Complex laplace_transform(const SupportMotion& motion, Complex s) {
  if (const auto* sine = std::get_if<SineMotion>(&motion)) {
    const double w = sine->angular_frequency;
    return sine->amplitude * w / (s * s + w * w);
  }
  Complex sum = 0;
  for (const Kink& kink : kinks(motion)) sum += kink.velocity_jump * std::exp(-s * kink.time);
  return sum / (s * s);
}

std::vector<Complex> transform_points(const Sampling& sampling) {
  const int length = inversion_length(sampling);
  const double time = length * sampling.step;
  std::vector<Complex> points;
  for (int k = 0; k <= length / 2; ++k) points.emplace_back(kDamping / time, 2 * kPi * k / time);
  return points;
}

std::vector<double> invert_transform(const Sampling& sampling,
                                     const std::vector<Complex>& transform) {
  const int length = inversion_length(sampling);
  require(transform.size() == static_cast<std::size_t>(length) / 2 + 1,
          fmt::format("inverse transform: {} values, but these samples need {}", transform.size(),
                      length / 2 + 1));
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> values(length);
  fft.inv(values, transform, length);
  values.resize(sample_count(sampling));
  // inv() divides by the length; the integral along the line by the time.
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] *= std::exp(kDamping * static_cast<double>(i) / length) / sampling.step;
  return values;
}

TipHistory integrate_by_transform(const BeamSystem& system, const SupportMotion& motion,
                                  const Sampling& sampling) {
  return history_by_transform(TransferFunction(system).at(transform_points(sampling)), motion,
                              sampling);
}

TipHistory history_by_transform(std::vector<Complex> values, const SupportMotion& motion,
                                const Sampling& sampling) {
  const std::vector<Complex> points = transform_points(sampling);
  for (std::size_t k = 0; k < points.size(); ++k) values[k] *= laplace_transform(motion, points[k]);
  TipHistory history;
  history.displacement = invert_transform(sampling, values);
  for (std::size_t k = 0; k < points.size(); ++k) values[k] *= points[k];
  history.velocity = invert_transform(sampling, values);
  for (std::size_t k = 0; k < points.size(); ++k) values[k] *= points[k];
  history.acceleration = invert_transform(sampling, values);
  for (int i = 0; i < sample_count(sampling); ++i) {
    history.time.push_back(i * sampling.step);
    history.support.push_back(displacement(motion, history.time.back()));
  }
  return history;
}

}  // namespace zona::beam
