#pragma once

#include "mpm/materials/equation_of_state.h"
#include "mpm/points/material_points.h"
#include "mpm/points/velocity_gradient.h"

namespace zona::mpm {

/// Constants of (4.45); zero switches a term off. The shock tube of 4.4.1 has 2 and 1.
struct ArtificialViscosity {
  double quadratic = 0;  ///< c_0 [-]
  double linear = 0;     ///< c_1 [-]
};

/// Pressure that does the work of a step in (4.40).
enum class EnergyIncrement {
  end_pressure,  ///< at the end of the step, as in the source; heats at first order in the step
  mean_pressure  ///< mean of start and end; a cycle produces no heat, to second order
};

/// Constants and initial state of a viscous compressible fluid.
struct FluidProperties {
  double density;              ///< initial [kg/m^3]
  StiffenedGas state;          ///< equation of state
  double pressure = 0;         ///< initial [Pa]
  double shear_viscosity = 0;  ///< mu [Pa s]; the bulk viscosity is -2 mu / 3 (Stokes)
  ArtificialViscosity artificial_viscosity;                          ///< (4.45)
  EnergyIncrement energy_increment = EnergyIncrement::end_pressure;  ///< in (4.40)
};

/// A viscous compressible fluid (4.28) with internal energy.
struct Fluid {
  /// Its points contribute internal forces.
  static constexpr bool has_stress = true;

  /// Points in the initial state. Throws ModelError.
  Fluid(const FluidProperties& properties, int points);

  FluidProperties properties;   ///< constants of all points
  double initial_energy;        ///< initial specific internal energy [J/kg]
  Field density;                ///< [kg/m^3]
  Field internal_energy;        ///< specific [J/kg]
  SymmetricTensorField stress;  ///< Cauchy [Pa]

  /// Speed of sound in the initial state [m/s].
  double wave_speed() const {
    return properties.state.sound_speed(properties.pressure, properties.density);
  }
  double shear_wave_speed() const { return 0; }  ///< fluids have no shear waves [m/s]
  /// Speed of sound [m/s] at a density [kg/m^3] and a specific internal energy [J/kg].
  Lanes sound_speed(const Lanes& rho, const Lanes& energy) const {
    const double big_gamma = properties.state.grueneisen;
    return square_root(larger(
        (big_gamma + 1) * big_gamma * (energy - properties.state.p_infinity / rho), Lanes{}));
  }
  /// Current volume [m^3] of a group of this mass [kg].
  Lanes volume(const PointGroup& group, const Lanes& mass) const {
    return mass / group.load(density);
  }
  /// Advances density (4.37), internal energy (4.40) and stress (4.39) by dt [s] at a velocity
  /// gradient [1/s]. `length` [m] is the characteristic length (4.46). Returns a mask of the points
  /// whose density is no longer positive.
  LaneMask update(const PointGroup& group, const VelocityGradient& gradient, double dt,
                  double length);

  /// Calls f(Field) for each field that a step changes.
  template <class F>
  void for_each_field(F f) {
    f(density);
    f(internal_energy);
    for (auto& component : stress) f(component);
  }
};

inline LaneMask Fluid::update(const PointGroup& group, const VelocityGradient& gradient, double dt,
                              double length) {
  const double big_gamma = properties.state.grueneisen;
  const double offset = (big_gamma + 1) * properties.state.p_infinity;
  const double mu = properties.shear_viscosity;
  const SymmetricTensorLanes rate = strain_rate(gradient);
  const Lanes divergence = trace(rate);
  const Lanes old_density = group.load(density);
  const Lanes old_energy = group.load(internal_energy);
  const Lanes new_density = old_density / (1.0 + dt * divergence);

  Lanes q{};
  const auto& artificial = properties.artificial_viscosity;
  if (artificial.quadratic > 0 || artificial.linear > 0) {
    const Lanes sound = sound_speed(old_density, old_energy);
    q = select(divergence < 0.0,
               new_density * length *
                   (artificial.quadratic * length * divergence * divergence -
                    artificial.linear * sound * divergence),
               Lanes{});
  }
  // The source iterates (4.36)-(4.41). The equation of state is linear in I, so one linear equation
  // gives the limit of the iteration.
  const Lanes dissipation =
      2.0 * mu * contract(rate, rate) - 2.0 / 3.0 * mu * divergence * divergence;
  const bool mean = properties.energy_increment == EnergyIncrement::mean_pressure;
  const double end_share = mean ? 0.5 : 1.0;
  const Lanes begin_pressure =
      mean ? 0.5 * (big_gamma * old_density * old_energy - offset) : Lanes{};
  const Lanes scale = dt / old_density;
  const Lanes stiffening = 1.0 + scale * divergence * (end_share * big_gamma) * new_density;
  const Lanes energy =
      (old_energy +
       scale * ((end_share * offset - begin_pressure - q) * divergence + dissipation)) /
      stiffening;
  const Lanes pressure = big_gamma * new_density * energy - offset + q;

  const Lanes spherical = -2.0 / 3.0 * mu * divergence - pressure;
  SymmetricTensorLanes new_stress;
  for (int c = 0; c < 3; ++c) new_stress[c] = 2.0 * mu * rate[c] + spherical;
  for (int c = 3; c < 6; ++c) new_stress[c] = 2.0 * mu * rate[c];
  group.store(density, new_density);
  group.store(internal_energy, energy);
  group.store(stress, new_stress);
  return ~((new_density > 0.0) & (new_density < HUGE_VAL) & (stiffening > 0.0));
}

}  // namespace zona::mpm
