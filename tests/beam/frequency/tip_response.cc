#include "beam/frequency/tip_response.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "beam/frequency/transfer_function.h"
#include "beam/frequency/transfer_sensitivity.h"

using namespace zona::beam;
using Complex = std::complex<double>;

namespace {

const Sampling run_sampling{10, 2e-3};

/// x(t) = exp(-a t) (sin t - t cos t) / 2, whose transform is 1 / ((s + a)^2 + 1)^2.
double decaying(double a, double time) {
  return std::exp(-a * time) * (std::sin(time) - time * std::cos(time)) / 2;
}

double decaying_rate(double a, double time) {
  return std::exp(-a * time) * time * std::sin(time) / 2 - a * decaying(a, time);
}

std::vector<Complex> transform(double a) {
  std::vector<Complex> values;
  for (const Complex s : transform_points(run_sampling))
    values.push_back(1. / std::pow((s + a) * (s + a) + 1., 2));
  return values;
}

std::vector<Complex> transform_by_a(double a) {
  std::vector<Complex> values;
  for (const Complex s : transform_points(run_sampling))
    values.push_back(-4. * (s + a) / std::pow((s + a) * (s + a) + 1., 3));
  return values;
}

/// Time of the greatest magnitude of f, by a search that ends at the rounding of f.
template <class Function>
double time_of_peak(const Function& f) {
  double best = 0;
  for (double step = 1e-2, low = 0, high = 10; step > 1e-9; step /= 10) {
    for (double time = low; time <= high; time += step)
      if (std::abs(f(time)) > std::abs(f(best))) best = time;
    low = best - 2 * step, high = best + 2 * step;
  }
  return best;
}

/// Last time at which |f| falls below the limit.
template <class Function>
double last_fall(const Function& f, double limit) {
  double above = 10;
  while (std::abs(f(above)) <= limit) above -= 1e-3;
  double below = above + 1e-3;
  for (int i = 0; i < 60; ++i) {
    const double middle = (above + below) / 2;
    (std::abs(f(middle)) > limit ? above : below) = middle;
  }
  return above;
}

}  // namespace

TEST_CASE("peaks and ring-down of a response are found between the samples") {
  const double a = 0.8, pulse_end = 0.5;
  const auto x = [&](double time) { return decaying(a, time); };
  const auto v = [&](double time) { return decaying_rate(a, time); };
  const double peak = std::abs(x(time_of_peak(x)));
  const TipResponse response(transform(a), run_sampling, pulse_end);
  // The inversion errs by exp(-16) of the response and of the frequencies that fade out, and the
  // linear interpolation by (2 ms)^2/8.
  CHECK(response.amplitude() == Approx(peak).epsilon(1e-5));
  CHECK(response.peak_velocity() == Approx(std::abs(v(time_of_peak(v)))).epsilon(1e-5));
  REQUIRE(response.ring_down());
  CHECK(*response.ring_down() == Approx(last_fall(x, 0.1 * peak) - pulse_end).epsilon(1e-5));
}

TEST_CASE("derivatives of peaks and ring-down are those of the exact response") {
  const double a = 0.8, end_rate = 0.25;
  const TipResponse response(transform(a), run_sampling, 0.5);
  const TipResponseDerivative derivative = response.derivative(transform_by_a(a), end_rate);
  const auto x = [](double b) { return [b](double time) { return decaying(b, time); }; };
  const auto v = [](double b) { return [b](double time) { return decaying_rate(b, time); }; };
  // Stationary at the peak: dx/da = -t x, dv/da = -t v - x.
  const double at_peak = time_of_peak(x(a)), at_fastest = time_of_peak(v(a));
  CHECK(derivative.amplitude == Approx(-at_peak * std::abs(x(a)(at_peak))).epsilon(1e-4));
  const double side = v(a)(at_fastest) < 0 ? -1 : 1;
  CHECK(derivative.peak_velocity ==
        Approx(side * (-at_fastest * v(a)(at_fastest) - x(a)(at_fastest))).epsilon(1e-4));
  const auto fall = [&](double b) {
    return last_fall(x(b), 0.1 * std::abs(x(b)(time_of_peak(x(b)))));
  };
  REQUIRE(derivative.ring_down);
  CHECK(*derivative.ring_down ==
        Approx((fall(a + 1e-4) - fall(a - 1e-4)) / 2e-4 - end_rate).epsilon(1e-3));
}

TEST_CASE("a response that still rings at the last sample has no ring-down") {
  const TipResponse response(transform(0.01), run_sampling, 0.5);
  CHECK_FALSE(response.ring_down());
  CHECK_FALSE(response.derivative(transform_by_a(0.01), 0).ring_down);
  CHECK_THROWS_AS(TipResponse({1., 2.}, run_sampling, 0), std::invalid_argument);
}

TEST_CASE("ring-down and residual amplitude of a sampled history") {
  TipHistory history;
  for (int i = 0; i < 20; ++i) {
    history.time.push_back(i);
    history.displacement.push_back(i == 3 ? -10 : i < 8 ? 2 : i == 12 ? 1.1 : 0.5);
  }
  CHECK(ring_down(history, 4) == 13 - 4);
  CHECK(ring_down(history, 15) == 0);
  CHECK(residual_amplitude(history) == 0.5);
  history.displacement.back() = -1.5;
  CHECK(ring_down(history, 4) == std::numeric_limits<double>::infinity());
  CHECK(residual_amplitude(history) == 1.5);
}

TEST_CASE("the transform of a pulse is differentiated by its kinks") {
  const double peak = 2e-6, duration = 60e-6, step = 1e-3 * duration;
  const auto pulse = [&](double d) { return trapezoidal_pulse(peak, d, 0.2 * d); };
  std::array<SupportMotion, 4> moved;
  for (std::size_t i = 0; i < moved.size(); ++i)
    moved[i] = pulse(duration + stencil_places[i] * step);
  const auto derivatives = kink_derivatives(pulse(duration), moved, step);
  REQUIRE(derivatives.size() == 4);
  CHECK(has_effect(derivatives, duration));
  CHECK(derivatives.back().rate.time == Approx(1));
  CHECK(derivatives.front().rate.velocity_jump ==
        Approx(-derivatives.front().kink.velocity_jump / duration));
  const std::vector<Complex> s{{2e3, 1e4}, {2e3, 1e5}};
  const double e = 1e-4 * duration;
  const auto more = laplace_transform(pulse(duration + e), s);
  const auto less = laplace_transform(pulse(duration - e), s);
  const auto exact = laplace_transform_derivative(derivatives, s);
  for (std::size_t k = 0; k < s.size(); ++k)  // central differences: (e/duration)^2 of it
    CHECK(std::abs(exact[k] - (more[k] - less[k]) / (2 * e)) < 1e-6 * std::abs(exact[k]));
  moved[0] = triangular_pulse(peak, duration);
  CHECK(kink_derivatives(pulse(duration), moved, step).empty());
  moved.fill(pulse(duration));
  CHECK_FALSE(has_effect(kink_derivatives(pulse(duration), moved, step), duration));
}
