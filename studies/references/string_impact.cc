#include "studies/references/string_impact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/references/displacement.h"
#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

struct Vector {
  double x, z;
};

/// An element: its tension, and the history of its summed strain and work.
struct Element {
  double length, tension = 0, strain = 0, energy = 0;
  Vector tangent{1, 0};
  double xx = 0, zz = 0, xz = 0;  ///< summed strain, fixed axes
};

void check(const StringImpact& impact, const StringResolution& resolution) {
  require_positive(impact.length, "length of the string");
  require_positive(impact.area, "cross-section");
  require_positive(impact.youngs_modulus, "Young's modulus");
  require_positive(impact.density, "density");
  require_positive(impact.block_mass, "mass of the block");
  require(impact.contact_length >= 0 && impact.contact_length < impact.length,
          "the contact is shorter than the string, not " + std::to_string(impact.contact_length) +
              " m");
  require(resolution.elements >= 2, "a string needs two elements or more");
  require_positive(resolution.end, "end time");
  require_positive(resolution.interval, "sampling interval");
  require(resolution.courant > 0 && resolution.courant <= 0.9,
          "the Courant number must be in (0, 0.9], not " + std::to_string(resolution.courant));
}

/// The right half of the string, x from the middle to the fixed end, and half of the block. Nodes
/// up to `last_contact` share the vertical motion of the block while it is there.
class HalfString {
 public:
  HalfString(const StringImpact& impact, int elements);

  double critical_step() const {
    return size_ / std::sqrt(impact_.youngs_modulus / impact_.density);
  }
  void step(double dt);
  bool in_contact() const { return in_contact_; }
  StringSample sample(double time) const;
  double largest_strain() const;

 private:
  int nodes() const { return static_cast<int>(position_.size()); }
  void update(Element& element, const Vector& a, const Vector& b, const Vector& da,
              const Vector& db) const;
  void find_forces();
  void kick(double dt);
  void drift(double dt);

  StringImpact impact_;
  double size_;
  int last_contact_;
  bool in_contact_ = true;
  double block_position_ = 0, block_velocity_, contact_force_ = 0;
  std::vector<double> mass_;
  std::vector<Vector> position_, velocity_, force_, move_;
  std::vector<Element> element_;
};

HalfString::HalfString(const StringImpact& impact, int elements)
    : impact_(impact), size_(0.5 * impact.length / elements) {
  last_contact_ = static_cast<int>(std::lround(0.5 * impact.contact_length / size_));
  const double element_mass = impact.density * impact.area * size_;
  mass_.assign(elements + 1, element_mass);
  mass_.front() = mass_.back() = 0.5 * element_mass;
  for (int i = 0; i <= elements; ++i) position_.push_back({i * size_, 0});
  velocity_.assign(elements + 1, {0, 0});
  force_ = move_ = velocity_;
  element_.assign(elements, Element{size_});
  double picked_up = 0;
  for (int i = 0; i <= last_contact_; ++i) picked_up += mass_[i];
  const double block = 0.5 * impact.block_mass;
  block_velocity_ = -impact.speed * block / (block + picked_up);
  for (int i = 0; i <= last_contact_; ++i) velocity_[i].z = block_velocity_;
}

void HalfString::update(Element& e, const Vector& a, const Vector& b, const Vector& da,
                        const Vector& db) const {
  const Vector span{b.x - a.x, b.z - a.z};
  const double length = std::hypot(span.x, span.z), stretch = length / size_;
  const Vector tangent{span.x / length, span.z / length};
  if (impact_.strain == StringStrain::summed) {
    const double middle = 0.5 * (length + e.length);
    const Vector change{(db.x - da.x) / middle, (db.z - da.z) / middle};
    const Vector t{0.5 * (tangent.x + e.tangent.x), 0.5 * (tangent.z + e.tangent.z)};
    e.xx += change.x * t.x;
    e.zz += change.z * t.z;
    e.xz += 0.5 * (change.x * t.z + change.z * t.x);
    e.strain = e.xx * tangent.x * tangent.x + e.zz * tangent.z * tangent.z +
               2 * e.xz * tangent.x * tangent.z;
  } else {
    e.strain = impact_.strain == StringStrain::biot ? stretch - 1 : std::log(stretch);
  }
  const double share = impact_.stress == StressMeasure::kirchhoff ? stretch : 1.0;
  const double tension = impact_.area * impact_.youngs_modulus * std::max(0.0, e.strain) / share;
  e.energy += 0.5 * (tension + e.tension) * (length - e.length);
  e.tension = tension;
  e.length = length;
  e.tangent = tangent;
}

void HalfString::find_forces() {
  std::fill(force_.begin(), force_.end(), Vector{0, 0});
  for (int i = 0; i + 1 < nodes(); ++i) {
    Element& e = element_[i];
    update(e, position_[i], position_[i + 1], move_[i], move_[i + 1]);
    const Vector pull{e.tension * e.tangent.x, e.tension * e.tangent.z};
    force_[i].x += pull.x;
    force_[i].z += pull.z;
    force_[i + 1].x -= pull.x;
    force_[i + 1].z -= pull.z;
  }
}

void HalfString::kick(double dt) {
  const int first_moving_x =
      impact_.contact == StringContact::bonded && in_contact_ ? last_contact_ + 1 : 1;
  for (int i = first_moving_x; i + 1 < nodes(); ++i) velocity_[i].x += dt * force_[i].x / mass_[i];
  int first_free = 0;
  if (in_contact_) {
    double force = 0, mass = 0.5 * impact_.block_mass;
    for (int i = 0; i <= last_contact_; ++i) {
      force += force_[i].z;
      mass += mass_[i];
    }
    block_velocity_ += dt * force / mass;
    contact_force_ = force * impact_.block_mass / mass;  // on both halves of the block
    for (int i = 0; i <= last_contact_; ++i) velocity_[i].z = block_velocity_;
    first_free = last_contact_ + 1;
  }
  for (int i = first_free; i + 1 < nodes(); ++i) velocity_[i].z += dt * force_[i].z / mass_[i];
}

void HalfString::drift(double dt) {
  for (int i = 0; i < nodes(); ++i) {
    move_[i] = {dt * velocity_[i].x, dt * velocity_[i].z};
    position_[i].x += move_[i].x;
    position_[i].z += move_[i].z;
  }
  block_position_ += dt * block_velocity_;
}

void HalfString::step(double dt) {
  kick(0.5 * dt);
  drift(dt);
  find_forces();
  kick(0.5 * dt);
  if (in_contact_ && contact_force_ < 0) {
    in_contact_ = false;
    contact_force_ = 0;
  }
}

StringSample HalfString::sample(double time) const {
  StringSample s{time, block_position_, block_velocity_, contact_force_, 0, 0};
  s.kinetic_energy = 0.5 * impact_.block_mass * block_velocity_ * block_velocity_;
  for (int i = 0; i < nodes(); ++i) {
    const Vector& v = velocity_[i];
    s.kinetic_energy += mass_[i] * (v.x * v.x + v.z * v.z);  // of both halves
  }
  for (const Element& e : element_) s.strain_energy += 2 * e.energy;
  return s;
}

double HalfString::largest_strain() const {
  double largest = 0;
  for (const Element& e : element_) largest = std::max(largest, e.strain);
  return largest;
}

void note(StringHistory& history, const HalfString& string, const StringSample& s) {
  if (s.displacement < history.deepest) {
    history.deepest = s.displacement;
    history.deepest_time = s.time;
  }
  history.largest_strain = std::max(history.largest_strain, string.largest_strain());
  const double initial = history.samples.front().kinetic_energy;
  const double error = std::abs(s.kinetic_energy + s.strain_energy - initial) / initial;
  history.energy_error = std::max(history.energy_error, error);
}

}  // namespace

StringImpact net_of_the_source() {
  return {1, 0.2 * 0.0125, 2e7, 2000, 4000 * 0.2 * 0.2 * 0.1, 0.2, 1};
}

double StringHistory::displacement(double time) const {
  return displacement_at(samples, time);
}

StringHistory string_impact(const StringImpact& impact, const StringResolution& resolution) {
  check(impact, resolution);
  HalfString string(impact, resolution.elements);
  const int samples = static_cast<int>(std::ceil(resolution.end / resolution.interval - 1e-9));
  const int steps = static_cast<int>(
      std::ceil(resolution.interval / (resolution.courant * string.critical_step())));
  const double dt = resolution.interval / steps;
  StringHistory history;
  history.lift_off_time = std::numeric_limits<double>::infinity();
  history.samples.push_back(string.sample(0));
  for (int i = 0; i < samples; ++i) {
    for (int k = 0; k < steps; ++k) {
      const bool before = string.in_contact();
      string.step(dt);
      if (before && !string.in_contact()) {
        history.lift_off_time = i * resolution.interval + (k + 1) * dt;
      }
    }
    history.samples.push_back(string.sample((i + 1) * resolution.interval));
    note(history, string, history.samples.back());
  }
  return history;
}

}  // namespace zona::studies::references
