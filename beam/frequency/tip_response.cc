#include "beam/frequency/tip_response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "beam/frequency/transfer_function.h"
#include "beam/frequency/transfer_sensitivity.h"

namespace zona::beam {
namespace {

using Complex = std::complex<double>;

/// The tip has rung down once it stays within this fraction of its peak.
constexpr double ring_down_fraction = 0.1;

double sign(double value) {
  return value < 0 ? -1 : 1;
}

}  // namespace

double ring_down(const TipHistory& history, double pulse_end) {
  const double limit =
      ring_down_fraction * std::abs(history.displacement[index_of_peak(history.displacement)]);
  std::size_t last = history.time.size();
  while (last > 0 && std::abs(history.displacement[last - 1]) <= limit) --last;
  if (last == history.time.size()) return std::numeric_limits<double>::infinity();
  return std::max(0., history.time[last] - pulse_end);
}

double residual_amplitude(const TipHistory& history) {
  double greatest = 0;
  for (std::size_t i = history.time.size() * 9 / 10; i < history.time.size(); ++i)
    greatest = std::max(greatest, std::abs(history.displacement[i]));
  return greatest;
}

std::vector<KinkDerivative> kink_derivatives(const SupportMotion& motion,
                                             const std::array<SupportMotion, 4>& moved,
                                             double step) {
  std::vector<KinkDerivative> derivatives;
  for (const Kink& kink : kinks(motion)) derivatives.push_back({kink, {}});
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const std::vector<Kink> moved_kinks = kinks(moved[i]);
    if (moved_kinks.size() != derivatives.size()) return {};
    const double weight = stencil_weights[i] / step;
    for (std::size_t k = 0; k < derivatives.size(); ++k) {
      derivatives[k].rate.time += weight * moved_kinks[k].time;
      derivatives[k].rate.velocity_jump += weight * moved_kinks[k].velocity_jump;
    }
  }
  return derivatives;
}

bool has_effect(const std::vector<KinkDerivative>& kinks, double value) {
  constexpr double rounding = 1e-9;
  return std::any_of(kinks.begin(), kinks.end(), [&](const KinkDerivative& derivative) {
    const auto& [kink, rate] = derivative;
    return std::abs(rate.time * value) > rounding * kinks.back().kink.time ||
           std::abs(rate.velocity_jump * value) > rounding * std::abs(kink.velocity_jump);
  });
}

std::vector<Complex> laplace_transform_derivative(const std::vector<KinkDerivative>& kinks,
                                                  const std::vector<Complex>& points) {
  std::vector<Complex> values;
  for (const Complex s : points) {
    Complex sum = 0;
    for (const auto& [kink, rate] : kinks)
      sum += (rate.velocity_jump - s * rate.time * kink.velocity_jump) * std::exp(-s * kink.time);
    values.push_back(sum / (s * s));
  }
  return values;
}

TipResponse::TipResponse(const std::vector<Complex>& transform, const Sampling& sampling,
                         double pulse_end)
    : sampling_(sampling), pulse_end_(pulse_end) {
  auto [displacement, velocity, acceleration] = invert_with_derivatives(sampling, transform);
  displacement_ = std::move(displacement);
  velocity_ = std::move(velocity);
  displacement_peak_ = peak_instant(displacement_, velocity_);
  velocity_peak_ = peak_instant(velocity_, acceleration);
  amplitude_ = cubic_value(displacement_peak_, displacement_, velocity_);
  peak_velocity_ = cubic_value(velocity_peak_, velocity_, acceleration);
  crossing_ = last_crossing(displacement_, ring_down_fraction * std::abs(amplitude_));
}

double TipResponse::amplitude() const {
  return std::abs(amplitude_);
}

double TipResponse::peak_velocity() const {
  return std::abs(peak_velocity_);
}

std::optional<double> TipResponse::ring_down() const {
  if (!crossing_) return std::nullopt;
  return (static_cast<double>(crossing_->sample) + crossing_->share) * sampling_.step - pulse_end_;
}

TipResponseDerivative TipResponse::derivative(const std::vector<Complex>& transform_derivative,
                                              double pulse_end_rate) const {
  const auto [displacement, velocity, acceleration] =
      invert_with_derivatives(sampling_, transform_derivative);
  TipResponseDerivative result;
  result.amplitude = sign(amplitude_) * cubic_value(displacement_peak_, displacement, velocity);
  result.peak_velocity = sign(peak_velocity_) * cubic_value(velocity_peak_, velocity, acceleration);
  if (!crossing_) return result;
  const double side = sign(linear_value(*crossing_, displacement_));
  result.ring_down =
      (ring_down_fraction * result.amplitude - side * linear_value(*crossing_, displacement)) /
          (side * linear_value(*crossing_, velocity_)) -
      pulse_end_rate;
  return result;
}

/// Zero of `slope` next to the greatest magnitude of `values`.
TipResponse::Instant TipResponse::peak_instant(const std::vector<double>& values,
                                               const std::vector<double>& slope) {
  const std::size_t peak = index_of_peak(values);
  for (const std::size_t first : {peak == 0 ? peak : peak - 1, peak}) {
    if (first + 1 >= values.size() || slope[first] * slope[first + 1] > 0) continue;
    const double span = slope[first] - slope[first + 1];
    return {first, span == 0 ? 0 : slope[first] / span};
  }
  return {peak, 0};
}

/// Last instant at which the magnitude falls below the limit; absent if it does not stay below.
std::optional<TipResponse::Instant> TipResponse::last_crossing(const std::vector<double>& values,
                                                               double limit) {
  std::size_t last = values.size();
  while (last > 0 && std::abs(values[last - 1]) <= limit) --last;
  if (last == 0 || last == values.size()) return std::nullopt;
  const double above = std::abs(values[last - 1]), below = std::abs(values[last]);
  return Instant{last - 1, (above - limit) / (above - below)};
}

double TipResponse::linear_value(const Instant& at, const std::vector<double>& values) {
  if (at.sample + 1 >= values.size()) return values.back();
  return (1 - at.share) * values[at.sample] + at.share * values[at.sample + 1];
}

/// Value of the cubic through the values and slopes of two samples.
double TipResponse::cubic_value(const Instant& at, const std::vector<double>& values,
                                const std::vector<double>& slope) const {
  if (at.sample + 1 >= values.size()) return values.back();
  const double x = at.share;
  const double a = values[at.sample], b = values[at.sample + 1];
  const double da = sampling_.step * slope[at.sample], db = sampling_.step * slope[at.sample + 1];
  return a * (1 + 2 * x) * (1 - x) * (1 - x) + da * x * (1 - x) * (1 - x) +
         b * x * x * (3 - 2 * x) - db * x * x * (1 - x);
}

}  // namespace zona::beam
