#pragma once

#include <cmath>

/// Exact solution of the Riemann problem for an ideal gas at rest on both sides, left pressure
/// above the right one: rarefaction, contact, shock (Toro, Riemann Solvers, chapter 4).
struct ShockTube {
  double gamma, rho_l, p_l, rho_r, p_r;

  struct State {
    double density, velocity, pressure;
  };

  double sound(double p, double rho) const { return std::sqrt(gamma * p / rho); }
  double shock_velocity_jump(double p) const {
    const double a = 2 / ((gamma + 1) * rho_r), b = (gamma - 1) / (gamma + 1) * p_r;
    return (p - p_r) * std::sqrt(a / (p + b));
  }
  double rarefaction_velocity(double p) const {
    return 2 * sound(p_l, rho_l) / (gamma - 1) * (1 - std::pow(p / p_l, (gamma - 1) / (2 * gamma)));
  }
  double star_pressure() const {
    double low = p_r, high = p_l;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (shock_velocity_jump(middle) < rarefaction_velocity(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  double shock_speed() const {
    const double ratio = star_pressure() / p_r;
    return sound(p_r, rho_r) *
           std::sqrt((gamma + 1) / (2 * gamma) * ratio + (gamma - 1) / (2 * gamma));
  }
  /// At s = (x - x0) / t.
  State at(double s) const {
    const double p = star_pressure(), u = rarefaction_velocity(p);
    const double c_l = sound(p_l, rho_l);
    const double rho_star_l = rho_l * std::pow(p / p_l, 1 / gamma);
    if (s < -c_l) return {rho_l, 0, p_l};
    if (s < u - sound(p, rho_star_l)) {
      const double c = 2 / (gamma + 1) * c_l - (gamma - 1) / (gamma + 1) * s;
      const double rho = rho_l * std::pow(c / c_l, 2 / (gamma - 1));
      return {rho, 2 / (gamma + 1) * (c_l + s), p_l * std::pow(rho / rho_l, gamma)};
    }
    if (s < u) return {rho_star_l, u, p};
    if (s < shock_speed()) {
      const double g = (gamma - 1) / (gamma + 1);
      return {rho_r * (p / p_r + g) / (g * p / p_r + 1), u, p};
    }
    return {rho_r, 0, p_r};
  }
};
