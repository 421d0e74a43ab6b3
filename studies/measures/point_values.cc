#include "studies/measures/point_values.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mpm/results/diagnostics.h"

namespace zona::studies {

namespace {

enum First : std::size_t {
  position = 0,
  displacement = 3,
  velocity = 6,
  stress = 9,
  equivalent_stress = 15,
  pressure = 16,
  density = 17,
  strain = 18,
  energy = 19,
  plastic_strain = 20,
  damage = 21,
  end = 22
};
static_assert(end == PointValues::count);

double von_mises(const double* s) {
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * shear);
}

/// Takes the internal variables of a law at a point; most laws have none.
template <class State>
void take_law(const State&, int, PointValues&) {}
void take_law(const mpm::SolidState<mpm::VonMises>& s, int p, PointValues& point) {
  point.value[plastic_strain] = s.internal[p];
  if (!s.surfaces.empty()) point.value[damage] = s.surfaces.opened[p];
}
void take_law(const mpm::SolidState<mpm::Elastodamage>& s, int p, PointValues& point) {
  point.value[damage] = 1 - s.integrity[p];
}
void take_law(const mpm::MembraneState<mpm::VonMises>& s, int p, PointValues& point) {
  point.value[plastic_strain] = s.internal[p];
}

void take_own(const mpm::Membrane& m, int p, PointValues& point) {
  std::visit([&](const auto& state) { take_law(state, p, point); }, m.state);
  point.value[density] = m.properties.density;
  point.value[strain] = m.strain[p];
  point.value[damage] = 1 - m.integrity.left[p];
}
void take_own(const mpm::Prescribed& m, int, PointValues& point) {
  point.value[density] = m.density;
}
void take_own(const mpm::Fluid& m, int p, PointValues& point) {
  point.value[density] = m.density[p];
}
template <class Law>
void take_own(const mpm::Solid<Law>& m, int p, PointValues& point) {
  take_law(m.state, p, point);
  point.value[density] = m.density[p];
}

template <class Material>
void take_state(const Material& m, int p, PointValues& point) {
  take_own(m, p, point);
  point.volume = point.mass / point.value[density];
  if constexpr (Material::has_stress) {
    for (int c = 0; c < 6; ++c) point.value[stress + c] = m.stress[c][p];
  }
  const double* s = &point.value[stress];
  point.value[equivalent_stress] = von_mises(s);
  point.value[pressure] = -(s[0] + s[1] + s[2]) / 3;
}

}  // namespace

const std::vector<PointQuantity>& point_quantities() {
  using Of = PointQuantity::Of;
  static const std::vector<std::string> vector{"x", "y", "z"}, scalar{""};
  static const std::vector<std::string> tensor{"xx", "yy", "zz", "xy", "yz", "zx"};
  static const std::vector<PointQuantity> quantities{
      {"position", "m", vector, position, false, Of::all},
      {"displacement", "m", vector, displacement, false, Of::all},
      {"velocity", "m/s", vector, velocity, false, Of::all},
      {"stress", "Pa", tensor, stress, true, Of::deformable},
      {"equivalent_stress", "Pa", scalar, equivalent_stress, true, Of::deformable},
      {"pressure", "Pa", scalar, pressure, true, Of::deformable},
      {"density", "kg/m^3", scalar, density, true, Of::deformable},
      {"strain", "", scalar, strain, true, Of::membranes},
      {"energy", "J/kg", scalar, energy, false, Of::deformable},
      {"plastic_strain", "", scalar, plastic_strain, true, Of::plastic},
      {"damage", "", scalar, damage, true, Of::failing}};
  return quantities;
}

const PointQuantity& point_quantity(const std::string& name) {
  for (const PointQuantity& quantity : point_quantities()) {
    if (quantity.name == name) return quantity;
  }
  throw std::logic_error("there is no quantity " + name);
}

PointValues values_at(const mpm::Body& body, int p, const Eigen::Vector3d& start) {
  PointValues point;
  point.mass = body.points.mass[p];
  const Eigen::Vector3d place = body.points.position_of(p);
  const Eigen::Vector3d speed = body.points.velocity_of(p);
  for (int axis = 0; axis < 3; ++axis) {
    point.value[position + axis] = place[axis];
    point.value[displacement + axis] = place[axis] - start[axis];
    point.value[velocity + axis] = speed[axis];
  }
  std::visit([&](const auto& material) { take_state(material, p, point); }, body.material);
  point.value[energy] = mpm::specific_energy(body, p);
  return point;
}

void PointMean::add(const PointValues& point) {
  for (const PointQuantity& quantity : point_quantities()) {
    const double weight = quantity.by_volume ? point.volume : point.mass;
    for (std::size_t c = 0; c < quantity.components.size(); ++c) {
      sum_.value[quantity.first + c] += weight * point.value[quantity.first + c];
    }
  }
  sum_.mass += point.mass;
  sum_.volume += point.volume;
  ++points_;
}

PointValues PointMean::mean() const {
  PointValues mean = sum_;
  for (const PointQuantity& quantity : point_quantities()) {
    const double weight = quantity.by_volume ? sum_.volume : sum_.mass;
    for (std::size_t c = 0; c < quantity.components.size(); ++c) {
      double& value = mean.value[quantity.first + c];
      value = points_ > 0 ? value / weight : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return mean;
}

std::vector<Column> columns_of(const PointQuantity& quantity, const std::string& prefix) {
  std::vector<Column> columns;
  for (const std::string& component : quantity.components) {
    const std::string suffix = component.empty() ? "" : "_" + component;
    columns.push_back({prefix + quantity.name + suffix, quantity.unit});
  }
  return columns;
}

}  // namespace zona::studies
