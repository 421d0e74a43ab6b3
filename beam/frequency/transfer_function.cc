#include "beam/frequency/transfer_function.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "beam/algebra/require.h"
#include "beam/frequency/frequency_lanes.h"

namespace zona::beam {

[[gnu::flatten, gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]] void
lanes::solve(const BeamSystem& system, const Factors& factors, BandSolve& band,
             Complexes& observed) {
  solve_relative(system, factors, band);
  observed = Complexes{};
  observed.re += system.support_share;
  for (int i = 0; i < system.size(); ++i)
    if (system.observation(i) != 0) add(observed, system.observation(i), band.solution(i));
}

namespace {

using namespace lanes;

/// Real part of s on the line of inversion, times the time span of the inversion. Aliases are
/// damped by exp(-16); errors grow by exp(8) from the first to the last sample.
constexpr double line_damping = 16;

/// Fades out the upper quarter of the frequencies. A sharp cut of a kink's spectrum would leave a
/// ripple along all samples, which the factor exp(t Re s) amplifies.
double fade(int k, int count) {
  const double place = 4. * k / count - 3;  // 0 to 1 over the upper quarter
  return place <= 0 ? 1 : std::pow(std::cos(0.5 * M_PI * place), 2);
}

int inversion_length(const Sampling& sampling) {
  int length = 2;
  while (length < 2 * sample_count(sampling)) length *= 2;
  return length;
}

}  // namespace

TransferFunction::TransferFunction(const BeamSystem& system) : system_(system) {
  require(!system.liquids.has_bath(BathModel::per_mode) && system.liquids.drag.empty(),
          "transform: a quadratic drag and a bath of the model per_mode have no transfer function; "
          "choose another integrator");
}

Complex TransferFunction::operator()(Complex s) const {
  return at({s}).front();
}

std::vector<Complex> TransferFunction::at(const std::vector<Complex>& s) const {
  std::vector<Complex> values(s.size());
  BandSolve band(system_.size());
  for (std::size_t first = 0; first < s.size(); first += lane_count) {
    const std::size_t count = std::min<std::size_t>(lane_count, s.size() - first);
    std::array<Complex, lane_count> lanes;
    for (int lane = 0; lane < lane_count; ++lane)
      lanes[lane] = s[first + std::min<std::size_t>(lane, count - 1)];
    Complexes observed;
    solve(system_, factors_at(system_, lanes.data()), band, observed);
    for (std::size_t lane = 0; lane < count; ++lane)
      values[first + lane] = {observed.re[lane], observed.im[lane]};
  }
  return values;
}

std::vector<Complex> laplace_transform(const SupportMotion& motion,
                                       const std::vector<Complex>& points) {
  std::vector<Complex> values;
  if (const auto* sine = std::get_if<SineMotion>(&motion)) {
    const double w = sine->angular_frequency;
    for (const Complex s : points) values.push_back(sine->amplitude * w / (s * s + w * w));
    return values;
  }
  const std::vector<Kink> all_kinks = kinks(motion);
  for (const Complex s : points) {
    Complex sum = 0;
    for (const Kink& kink : all_kinks) sum += kink.velocity_jump * std::exp(-s * kink.time);
    values.push_back(sum / (s * s));
  }
  return values;
}

std::vector<Complex> transform_points(const Sampling& sampling) {
  const int length = inversion_length(sampling);
  const double time = length * sampling.step;
  std::vector<Complex> points;
  for (int k = 0; k <= length / 2; ++k)
    points.emplace_back(line_damping / time, 2 * M_PI * k / time);
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
  std::vector<Complex> faded(transform);
  for (int k = 0; k <= length / 2; ++k) faded[k] *= fade(k, length / 2);
  std::vector<double> values(length);
  fft.inv(values, faded, length);
  values.resize(sample_count(sampling));
  // inv() divides by the length, but the integral along the line by the time.
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] *= std::exp(line_damping * static_cast<double>(i) / length) / sampling.step;
  return values;
}

std::array<std::vector<double>, 3> invert_with_derivatives(const Sampling& sampling,
                                                           std::vector<Complex> transform) {
  const std::vector<Complex> points = transform_points(sampling);
  std::array<std::vector<double>, 3> derivatives{invert_transform(sampling, transform)};
  for (const int order : {1, 2}) {
    for (std::size_t k = 0; k < points.size(); ++k) transform[k] *= points[k];
    derivatives[order] = invert_transform(sampling, transform);
  }
  return derivatives;
}

TipHistory integrate_by_transform(const BeamSystem& system, const SupportMotion& motion,
                                  const Sampling& sampling) {
  return history_by_transform(TransferFunction(system).at(transform_points(sampling)), motion,
                              sampling);
}

TipHistory history_by_transform(std::vector<Complex> values, const SupportMotion& motion,
                                const Sampling& sampling) {
  const std::vector<Complex> support = laplace_transform(motion, transform_points(sampling));
  for (std::size_t k = 0; k < support.size(); ++k) values[k] *= support[k];
  auto [displacement_at, velocity_at, acceleration_at] =
      invert_with_derivatives(sampling, std::move(values));
  TipHistory history;
  history.displacement = std::move(displacement_at);
  history.velocity = std::move(velocity_at);
  history.acceleration = std::move(acceleration_at);
  for (int i = 0; i < sample_count(sampling); ++i) {
    history.time.push_back(i * sampling.step);
    history.support.push_back(displacement(motion, history.time.back()));
  }
  return history;
}

}  // namespace zona::beam
