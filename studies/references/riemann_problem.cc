#include "studies/references/riemann_problem.h"

#include <algorithm>
#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

/// One side of the problem in the ideal gas' formulas; `direction` is -1 for the left side.
struct Side {
  mpm::StiffenedGas gas;
  FluidState state;
  double direction;

  double gamma() const { return gas.grueneisen + 1; }
  double sound() const { return gas.sound_speed(state.pressure, state.density); }
  double stiff(double p) const { return p + gas.p_infinity; }

  /// (u* - u) along the direction of the side's wave when the pressure behind it is p.
  double velocity_jump(double p) const {
    const double g = gamma(), stiff_0 = stiff(state.pressure);
    if (p > state.pressure) {
      const double a = 2 / ((g + 1) * state.density), b = (g - 1) / (g + 1) * stiff_0;
      return (p - state.pressure) * std::sqrt(a / (stiff(p) + b));
    }
    const double ratio = std::max(0.0, stiff(p)) / stiff_0;
    return 2 * sound() / (g - 1) * (std::pow(ratio, (g - 1) / (2 * g)) - 1);
  }
  double star_density(double p) const {
    const double g = gamma(), ratio = stiff(p) / stiff(state.pressure);
    if (p <= state.pressure) return state.density * std::pow(ratio, 1 / g);
    const double k = (g - 1) / (g + 1);
    return state.density * (ratio + k) / (k * ratio + 1);
  }
  SideWave wave(double p, double u) const {
    const double g = gamma();
    if (p > state.pressure) {
      const double ratio = stiff(p) / stiff(state.pressure);
      const double relative = sound() * std::sqrt((g + 1) / (2 * g) * ratio + (g - 1) / (2 * g));
      const double speed = state.velocity + direction * relative;
      return {true, speed, speed};
    }
    return {false, state.velocity + direction * sound(),
            u + direction * gas.sound_speed(p, star_density(p))};
  }
  /// Within the rarefaction fan, at x/t = s.
  FluidState in_fan(double s) const {
    const double g = gamma(), a = sound();
    const double local = 2 / (g + 1) * a + (g - 1) / (g + 1) * direction * (s - state.velocity);
    const double p = stiff(state.pressure) * std::pow(local / a, 2 * g / (g - 1)) - gas.p_infinity;
    const double density = state.density * std::pow(local / a, 2 / (g - 1));
    return {density, s - direction * local, p, gas.internal_energy(p, density)};
  }
};

void check(const Side& side) {
  require_positive(side.gas.grueneisen, "Grueneisen exponent (gamma - 1)");
  require_positive(side.state.density, "density on both sides");
  require_positive(side.stiff(side.state.pressure), "pressure (plus P_inf) on both sides");
}

double star_pressure(const Side& left, const Side& right) {
  const double closing = left.state.velocity - right.state.velocity;
  const auto parts = [&](double p) {
    return left.velocity_jump(p) + right.velocity_jump(p) - closing;
  };
  double low = -std::min(left.gas.p_infinity, right.gas.p_infinity);
  require(parts(low) < 0, "the two fluids part at " + std::to_string(-closing) +
                              " m/s and leave a vacuum; this solver has none");
  double high = std::max(left.state.pressure, right.state.pressure);
  while (parts(high) < 0) high += std::max(left.stiff(high), right.stiff(high));
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (parts(middle) < 0 ? low : high) = middle;
  }
}

FluidState star_state(const Side& side, double p, double u) {
  const double density = side.star_density(p);
  return {density, u, p, side.gas.internal_energy(p, density)};
}

}  // namespace

RiemannSolution solve_riemann(const mpm::StiffenedGas& left_gas, FluidState left,
                              const mpm::StiffenedGas& right_gas, FluidState right) {
  const Side l{left_gas, left, -1}, r{right_gas, right, 1};
  check(l);
  check(r);
  left.internal_energy = left_gas.internal_energy(left.pressure, left.density);
  right.internal_energy = right_gas.internal_energy(right.pressure, right.density);
  const double p = star_pressure(l, r);
  const double u = 0.5 * (left.velocity - l.velocity_jump(p) + right.velocity + r.velocity_jump(p));
  return {left_gas,     right_gas,   left, right, star_state(l, p, u), star_state(r, p, u),
          l.wave(p, u), r.wave(p, u)};
}

FluidState RiemannSolution::at(double speed) const {
  const bool is_left = speed < left_star.velocity;
  const Side side = is_left ? Side{left_gas, left, -1} : Side{right_gas, right, 1};
  const SideWave& wave = is_left ? left_wave : right_wave;
  // Distances from the contact, positive towards the undisturbed fluid.
  if (side.direction * (speed - wave.head) >= 0) return side.state;
  if (side.direction * (speed - wave.tail) <= 0) return is_left ? left_star : right_star;
  return side.in_fan(speed);
}

RiemannSolution solve_shock_tube(double heat_capacity_ratio, FluidState left, FluidState right) {
  const auto gas = mpm::StiffenedGas::ideal_gas(heat_capacity_ratio);
  return solve_riemann(gas, left, gas, right);
}

RiemannSolution shock_tube_of_the_source() {
  return solve_shock_tube(1.4, {1, 0, 1, 0}, {0.125, 0, 0.001, 0});
}

RiemannSolution sods_tube() {
  return solve_shock_tube(1.4, {1, 0, 1, 0}, {0.125, 0, 0.1, 0});
}

}  // namespace zona::studies::references
