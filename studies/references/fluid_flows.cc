#include "studies/references/fluid_flows.h"

#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

void check(const SuddenWall& wall) {
  require_positive(wall.viscosity, "viscosity");
  require_positive(wall.density, "density");
}

/// Images of the wall at 2 n h and of its negative at 2 n h - y keep the wall at y = h at rest.
double couette_by_images(const SuddenWall& wall, double gap, double y, double time) {
  double u = 0;
  for (int n = 0; n < 20; ++n) {
    u += sudden_wall_velocity(wall, 2 * n * gap + y, time) -
         sudden_wall_velocity(wall, 2 * (n + 1) * gap - y, time);
  }
  return u;
}

double couette_by_modes(const SuddenWall& wall, double gap, double y, double time) {
  const double rate = M_PI * M_PI * wall.kinematic_viscosity() / (gap * gap);
  double sum = 0;
  for (int n = 1; n <= 40; ++n) {
    sum += std::sin(n * M_PI * y / gap) / n * std::exp(-rate * n * n * time);
  }
  return wall.speed * (1 - y / gap - 2 / M_PI * sum);
}

}  // namespace

double sudden_wall_velocity(const SuddenWall& wall, double y, double time) {
  check(wall);
  require(y >= 0, "the fluid is at y >= 0, not " + std::to_string(y) + " m");
  if (time <= 0) return 0;
  return wall.speed * std::erfc(y / std::sqrt(4 * wall.kinematic_viscosity() * time));
}

double sudden_wall_stress(const SuddenWall& wall, double time) {
  check(wall);
  require_positive(time, "time: the stress at the start is infinite");
  return wall.viscosity * wall.speed / std::sqrt(M_PI * wall.kinematic_viscosity() * time);
}

double couette_velocity(const SuddenWall& wall, double gap, double y, double time) {
  check(wall);
  require_positive(gap, "gap");
  require(y >= 0 && y <= gap, "the fluid is between the walls, not at " + std::to_string(y) + " m");
  if (time <= 0) return 0;
  const bool early = wall.kinematic_viscosity() * time < 0.1 * gap * gap;
  return early ? couette_by_images(wall, gap, y, time) : couette_by_modes(wall, gap, y, time);
}

double StandingWave::wave_number() const {
  require_positive(length, "length");
  require(mode >= 1, "a standing wave has one half wave or more, not " + std::to_string(mode));
  return mode * M_PI / length;
}

double StandingWave::decay_rate() const {
  require_positive(density, "density");
  const double k = wave_number();
  return 2.0 / 3 * viscosity / density * k * k;
}

double StandingWave::angular_frequency() const {
  const double undamped = sound_speed * wave_number(), decay = decay_rate();
  require(decay < undamped, "the wave is overdamped: its decay rate of " + std::to_string(decay) +
                                " 1/s exceeds " + std::to_string(undamped) + " rad/s");
  return std::sqrt(undamped * undamped - decay * decay);
}

AcousticState standing_wave(const StandingWave& wave, double x, double time) {
  const double k = wave.wave_number(), decay = wave.decay_rate(), omega = wave.angular_frequency();
  const double envelope = wave.speed * std::exp(-decay * time);
  const double a = envelope * std::sin(omega * time) / omega;
  const double rate = envelope * std::cos(omega * time) - decay * a;
  const double modulus = wave.density * wave.sound_speed * wave.sound_speed;
  return {rate * std::sin(k * x), -modulus * k * std::cos(k * x) * a};
}

FreeFall free_fall(double position, double velocity, double gravity, double time) {
  return {position + time * (velocity - 0.5 * gravity * time), velocity - gravity * time};
}

}  // namespace zona::studies::references
