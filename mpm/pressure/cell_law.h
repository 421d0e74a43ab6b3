#pragma once

#include <algorithm>

#include "mpm/bodies/fluid_cells.h"

namespace zona::mpm {

/// Pressure of the points of a fluid in a cell, averaged by volume, after a step in which all have
/// the same volumetric strain x. It is what Fluid::update gives to the points, (4.36)-(4.41): the
/// equation of state is linear in rho and in rho I, so that the average needs only the cell's sums.
/// Work of viscous stresses is left out; the points take it up after the step.
class CellLaw {
 public:
  /// For a step of dt [s]; `length` [m] is the characteristic length (4.46).
  CellLaw(const FluidProperties& fluid, const FluidSums& sums, double dt, double length)
      : big_gamma_(fluid.state.grueneisen),
        offset_((big_gamma_ + 1) * fluid.state.p_infinity),
        energy_(sums.energy / sums.volume) {
    const bool mean = fluid.energy_increment == EnergyIncrement::mean_pressure;
    const double end_share = mean ? 0.5 : 1.0;
    work_ = end_share * offset_ - (mean ? 0.5 * (big_gamma_ * energy_ - offset_) : 0.0);
    growth_ = 1 + end_share * big_gamma_;
    const auto& artificial = fluid.artificial_viscosity;
    const double scale = length / (dt * sums.volume);
    linear_ = artificial.linear * scale * sums.mass_sound;
    quadratic_ = artificial.quadratic * scale * (length / dt) * sums.mass;
  }

  /// Pressure with artificial viscosity [Pa] at a strain above -1 / growth.
  double pressure(double x) const {
    const double q = artificial(x);
    return big_gamma_ * (energy_ + (work_ - q) * x) / (1 + growth_ * x) - offset_ + q;
  }
  /// -dP/dx [Pa], positive: rho a^2 at x = 0.
  double stiffness(double x) const {
    const double q = artificial(x);
    const double q_slope = x < 0 ? (2 * quadratic_ * x - linear_ - q) / (1 + x) : 0;
    const double expanded = 1 + growth_ * x;
    const double energy = energy_ + (work_ - q) * x;
    return big_gamma_ * (growth_ * energy - (work_ - q - q_slope * x) * expanded) /
               (expanded * expanded) -
           q_slope;
  }
  /// The lowest strain that the law describes.
  double lowest() const { return -1 / growth_; }

 private:
  double artificial(double x) const {
    return x < 0 ? (quadratic_ * x * x - linear_ * x) / (1 + x) : 0;
  }

  double big_gamma_;
  double offset_;     ///< (Gamma + 1) P_inf [Pa]
  double energy_;     ///< internal energy per volume [Pa]
  double work_;       ///< work per strain, but for the share of the pressure at the end [Pa]
  double growth_;     ///< [-]
  double linear_;     ///< of artificial viscosity [Pa]
  double quadratic_;  ///< [Pa]
};

}  // namespace zona::mpm
