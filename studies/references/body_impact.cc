#include "studies/references/body_impact.h"

#include <algorithm>
#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

const ImpactBody& body_at(const BodyImpact& impact, ImpactSide side) {
  return side == ImpactSide::target ? impact.target : impact.projectile;
}
const ImpactBody& other_body(const BodyImpact& impact, ImpactSide side) {
  return side == ImpactSide::target ? impact.projectile : impact.target;
}

/// Transit time to the rear face and back to the contact [s].
double round_trip(const ImpactBody& body) {
  return 2 * body.width / body.wave_speed();
}

void check_distance(const ImpactBody& body, double distance) {
  require(distance >= 0 && distance <= body.width,
          "a point " + std::to_string(distance) + " m from the contact is outside the body of " +
              std::to_string(body.width) + " m");
}

/// From the corner at height 0 on the contact to a point `distance` into `body`, `height` up.
double first_arrival(const ImpactBody& body, const ImpactBody& other, double distance,
                     double height) {
  const double own = body.wave_speed(), fast = other.wave_speed();
  const double direct = std::hypot(distance, height) / own;
  if (fast <= own) return direct;
  const double sine = own / fast, cosine = std::sqrt(1 - sine * sine);
  if (distance * sine / cosine > height) return direct;
  return height / fast + distance * cosine / own;
}

}  // namespace

double ImpactBody::wave_speed() const {
  require_positive(youngs_modulus, "Young's modulus");
  require_positive(density, "density");
  require(poisson_ratio > -1 && poisson_ratio < 0.5,
          "Poisson's ratio must be in (-1, 0.5), not " + std::to_string(poisson_ratio));
  const double nu = poisson_ratio;
  return std::sqrt(youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu) * density));
}

BodyImpact impact_of_the_source() {
  return {{7e10, 0.33, 2700, 0.1}, {2e11, 0.3, 7800, 0.1}, 10, 0.3};
}

ImpactState impact_plateau(const BodyImpact& impact, ImpactSide side) {
  const double z1 = impact.projectile.impedance(), z2 = impact.target.impedance();
  const double stress = -z1 * z2 * impact.speed / (z1 + z2);
  const double nu = body_at(impact, side).poisson_ratio;
  return {stress, nu / (1 - nu) * stress, z1 * impact.speed / (z1 + z2)};
}

ImpactState impact_state(const BodyImpact& impact, ImpactSide side, double distance, double time) {
  const ImpactBody& body = body_at(impact, side);
  check_distance(body, distance);
  const double limit = std::min(round_trip(impact.projectile), round_trip(impact.target));
  require(time < limit, "the impact is known until " + std::to_string(limit * 1e6) +
                            " us, when a release comes back to the contact; asked for " +
                            std::to_string(time * 1e6) + " us");
  const double initial = side == ImpactSide::target ? 0 : impact.speed;
  const double c = body.wave_speed();
  const ImpactState plateau = impact_plateau(impact, side);
  if (time < distance / c) return {0, 0, initial};
  if (time < (2 * body.width - distance) / c) return plateau;
  return {0, 0, 2 * plateau.velocity - initial};
}

ImpactWindow impact_window(const BodyImpact& impact, ImpactSide side, double distance,
                           double from_edge) {
  const ImpactBody &body = body_at(impact, side), &other = other_body(impact, side);
  check_distance(body, distance);
  require(from_edge >= 0 && from_edge <= 0.5 * impact.height,
          "the distance to the nearer edge is within half the height, not " +
              std::to_string(from_edge) + " m");
  const double c = body.wave_speed();
  const double own_rear = (2 * body.width - distance) / c;
  const double other_rear = round_trip(other) + distance / c;
  return {distance / c, first_arrival(body, other, distance, from_edge),
          std::min(own_rear, other_rear)};
}

}  // namespace zona::studies::references
