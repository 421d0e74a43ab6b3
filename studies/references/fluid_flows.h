#pragma once

namespace zona::studies::references {

/// Stokes' first problem: a viscous fluid at rest above a wall that starts at t = 0 to move in its
/// plane. Momentum diffuses, u_t = (mu/rho) u_yy; the solution depends on y/sqrt(4 nu t) alone.
struct SuddenWall {
  double viscosity;  ///< mu [Pa s]
  double density;    ///< [kg/m^3]
  double speed;      ///< of the wall [m/s]

  double kinematic_viscosity() const { return viscosity / density; }
};

/// u = U erfc(y/sqrt(4 nu t)) [m/s] at a distance y [m] from the wall; the wall at t <= 0 rests.
double sudden_wall_velocity(const SuddenWall& wall, double y, double time);
/// Shear stress [Pa] with which the wall drags the fluid: mu U/sqrt(pi nu t), t > 0.
double sudden_wall_stress(const SuddenWall& wall, double time);

/// Start-up of Couette flow: as above, with a second wall at rest at a distance `gap` [m].
///   u/U = 1 - y/h - (2/pi) sum_n sin(n pi y/h)/n exp(-n^2 pi^2 nu t/h^2);
/// for nu t/h^2 < 0.1 the equal sum of images of the half-space, which converges at once there.
double couette_velocity(const SuddenWall& wall, double gap, double y, double time);

/// Standing acoustic wave between two rigid walls at x = 0 and x = length: at t = 0 the fluid has
/// no overpressure and the velocity U sin(k x), k = mode pi/length.
struct StandingWave {
  double sound_speed;  ///< c [m/s]
  double density;      ///< [kg/m^3]
  double viscosity;    ///< shear viscosity mu; Stokes' condition makes the bulk viscosity 0 [Pa s]
  double length;       ///< [m]
  int mode;            ///< half waves between the walls
  double speed;        ///< U, amplitude of the velocity [m/s]

  double wave_number() const;
  /// delta = (4/3 mu)/(2 rho) k^2 [1/s]: amplitudes decay as exp(-delta t), energies as exp(-2
  /// delta t).
  double decay_rate() const;
  /// sqrt(c^2 k^2 - delta^2) [rad/s]. Throws ModelError when the wave is overdamped.
  double angular_frequency() const;
};

/// Velocity and pressure above the static one.
struct AcousticState {
  double velocity;  ///< [m/s]
  double pressure;  ///< thermodynamic, without the viscous part of the stress [Pa]
};

/// Displacements sin(k x) a(t) obey a'' + 2 delta a' + c^2 k^2 a = 0 (linear acoustics: U << c;
/// without heat conduction), a(0) = 0, a'(0) = U. The pressure is -rho c^2 k cos(k x) a.
AcousticState standing_wave(const StandingWave& wave, double x, double time);

/// Free fall.
struct FreeFall {
  double position;  ///< z0 + v0 t - g t^2/2 [m]
  double velocity;  ///< v0 - g t [m/s]
};
FreeFall free_fall(double position, double velocity, double gravity, double time);

}  // namespace zona::studies::references
