#include "studies/references/elastoplastic_bar.h"

#include <algorithm>
#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

void check(const SteppedBar& bar, double x, double time) {
  require_positive(bar.length, "length of the bar");
  require_positive(bar.yield_stress, "yield stress");
  require(std::abs(bar.step) <= bar.yield_stress,
          "the step of " + std::to_string(bar.step) + " Pa exceeds the yield stress");
  require(x >= 0 && x <= bar.length, "x = " + std::to_string(x) + " m is outside the bar of " +
                                         std::to_string(bar.length) + " m");
  require(time >= 0, "the bar is known from t = 0 on, not at " + std::to_string(time) + " s");
}

/// The part of an arriving p that the mid-section carries.
double carried(const SteppedBar& bar, double p) {
  return std::clamp(p, -bar.yield_stress, bar.yield_stress);
}

/// sigma - Z v that the left end emits in its `period`-th interval of L/c; zero before the first.
double emitted(const SteppedBar& bar, int period) {
  if (period < 0) return 0;
  double p = 2 * bar.step;
  for (int n = 0; n < period; ++n) p = 2 * bar.step - (2 * carried(bar, p) - p);
  return p;
}

/// Number of the interval of L/c in which `time` lies; negative before t = 0.
int period_at(const SteppedBar& bar, double time) {
  return static_cast<int>(std::floor(time / bar.transit_time()));
}

}  // namespace

double SteppedBar::wave_speed() const {
  require_positive(youngs_modulus, "Young's modulus");
  require_positive(density, "density");
  return std::sqrt(youngs_modulus / density);
}

SteppedBar bar_of_the_source() {
  return {10, 72e9, 2810, 300e6, 200e6};
}

BarState free_bar_state(const SteppedBar& bar, double x, double time) {
  check(bar, x, time);
  const bool right = x > 0.5 * bar.length;
  const double from_end = right ? bar.length - x : x;
  const double c = bar.wave_speed(), z = bar.density * c;
  const double p = emitted(bar, period_at(bar, time - from_end / c));
  const double met = emitted(bar, period_at(bar, time - (bar.length - from_end) / c));
  const double q = 2 * carried(bar, met) - met;
  const double stress = 0.5 * (p + q), velocity = 0.5 * (q - p) / z;
  return {stress, std::abs(stress), right ? -velocity : velocity, 0};
}

double mid_section_opening(const SteppedBar& bar, double time) {
  check(bar, 0, time);
  const double z = bar.density * bar.wave_speed(), period = bar.transit_time();
  const double since = time - 0.5 * period;
  double opening = 0;
  for (int n = 0; n * period < since; ++n) {
    const double p = emitted(bar, n);
    opening += 2 * (p - carried(bar, p)) / z * std::min(period, since - n * period);
  }
  return opening;
}

BarState held_bar_state(const SteppedBar& bar, double x, double time) {
  check(bar, x, time);
  require(time <= bar.transit_time() * (1 + 1e-12),
          "the bar with held sides is known until L/c = " + std::to_string(bar.transit_time()) +
              " s, not at " + std::to_string(time) + " s");
  const double excess = 2 * bar.step - carried(bar, 2 * bar.step);
  const double since = time - 0.5 * bar.transit_time();
  const double from_middle = std::abs(x - 0.5 * bar.length);
  const double plastic_speed = bar.wave_speed() / std::sqrt(3.0);
  if (excess == 0 || since <= 0 || from_middle > plastic_speed * since) {
    return free_bar_state(bar, x, time);
  }
  const double rise = excess / std::sqrt(3.0);
  return {carried(bar, 2 * bar.step) + rise, bar.yield_stress, 0, 2 * rise / bar.youngs_modulus};
}

}  // namespace zona::studies::references
