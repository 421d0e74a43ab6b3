#include "studies/references/indented_egg.h"

#include <algorithm>
#include <cmath>

#include "studies/references/inflated_sphere.h"
#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

using Eigen::VectorXd;

/// Final share of the law without wrinkles. A tenth of it changes displacements by 1e-5.
constexpr double least_share = 1e-4;

void check(const IndentedEgg& egg, const std::vector<double>& forces, int elements) {
  check(egg.membrane);
  require_positive(egg.radius, "radius of the egg");
  require_positive(egg.pipette_outer, "outer radius of the pipette");
  require(egg.pipette_outer < egg.radius, "the pipette is thinner than the egg");
  require(egg.pipette_inner >= 0 && egg.pipette_inner < egg.pipette_outer,
          "the bore is narrower than the pipette");
  require(!(egg.bulk_modulus <= 0), "the bulk modulus is positive");
  require(egg.support != EggSupport::held ||
              (egg.support_radius > 0 && egg.support_radius < egg.radius),
          "a held egg needs a support radius below its own");
  require(elements >= 20, "an egg needs 20 elements or more");
  require(!forces.empty() && forces.front() > 0 && std::is_sorted(forces.begin(), forces.end()),
          "forces are positive and rise");
}

/// The egg as a meridian from the bottom over the pipette's outer edge (node `rim`) to its bore's.
struct EggModel {
  Meridian meridian;
  MeridianLoads loads;
  int rim;
  double touch;  ///< height at which the pipette touches first [m]
};

/// Angles from the top at which nodes lie, from the bottom up.
std::vector<double> node_angles(const IndentedEgg& egg, int elements) {
  constexpr double grading = 2.5;  // the first element at the pipette is 0.41 of the mean one
  const double rim = std::asin(egg.pipette_outer / egg.radius);
  std::vector<double> angles;
  for (int i = elements; i >= 0; --i) {
    const double t = std::sinh(grading * i / elements) / std::sinh(grading);
    angles.push_back(rim + (M_PI - rim) * t);
  }
  if (egg.pipette_inner > 0) {
    const double bore = std::asin(egg.pipette_inner / egg.radius);
    const int inside = std::max(10, elements / 10);
    for (int i = inside; i >= 0; --i) angles.push_back(bore * i / inside);
  }
  return angles;
}

EggModel build(const IndentedEgg& egg, int elements) {
  const auto angles = node_angles(egg, elements);
  const int nodes = static_cast<int>(angles.size());
  EggModel model{
      {egg.membrane, VectorXd::Zero(2 * nodes), egg.summed}, {}, elements, 2 * egg.radius};
  VectorXd& reference = model.meridian.reference;
  std::vector<int>& unknown = model.loads.unknown;
  const bool open = egg.pipette_inner > 0;
  int count = 0;
  model.loads.loaded = count++;
  for (int i = 0; i < nodes; ++i) {
    const bool pole = i == 0 || (open && i == nodes - 1);
    reference[2 * i] = pole ? 0 : egg.radius * std::sin(angles[i]);
    reference[2 * i + 1] = egg.radius * (1 + std::cos(angles[i]));
    const bool face = i == elements || (open && i == elements + 1);
    const bool held = egg.support == EggSupport::held && angles[i] > M_PI / 2 &&
                      reference[2 * i] <= egg.support_radius;
    unknown.push_back(pole || face || held ? -1 : count++);
    unknown.push_back(face ? model.loads.loaded : held ? -1 : count++);
  }
  if (open) model.touch = reference[2 * elements + 3];
  model.loads.filled = true;
  model.loads.volume = 4 * M_PI / 3 * std::pow(egg.radius, 3);
  model.loads.bulk_modulus = egg.bulk_modulus;
  // Deep enough to hold up the pressure, some hundred Pa, at a nanometre or less.
  const double stiffness =
      egg.membrane.youngs_modulus * egg.membrane.thickness / std::pow(egg.radius, 2);
  if (egg.support != EggSupport::held) model.loads.plate_stiffness = 1e4 * stiffness;
  return model;
}

/// A sphere somewhat larger than the egg, flat where the pipette is; less so near what is held.
MeridianState inflated(const EggModel& model, double growth) {
  const VectorXd& home = model.meridian.reference;
  const double radius = 0.5 * home.maxCoeff();
  MeridianState state;
  state.position = home;
  int held = 0;
  while (model.loads.unknown[2 * held + 1] < 0) ++held;
  for (int i = 0; i < model.meridian.nodes(); ++i) {
    const Eigen::Vector2d from_centre(home[2 * i], home[2 * i + 1] - radius);
    const double away =
        std::hypot(home[2 * i] - home[2 * held], home[2 * i + 1] - home[2 * held + 1]);
    const double share = held > 0 ? std::min(1.0, away / (0.5 * radius)) : 1;
    const bool fixed = i < held;
    if (!fixed) state.position.segment<2>(2 * i) += share * (growth - 1) * from_centre;
  }
  const double face = state.position[2 * model.rim + 1];
  for (int i = model.rim; i < model.meridian.nodes(); ++i) {
    if (model.loads.unknown[2 * i] < 0) state.position[2 * i] = home[2 * i];
    if (model.loads.unknown[2 * i + 1] == model.loads.loaded) state.position[2 * i + 1] = face;
  }
  return state;
}

/// Nodes that lie on the plate stay where they are from now on.
void stick(EggModel& model, const VectorXd& position) {
  for (int i = 0; i < model.meridian.nodes(); ++i) {
    if (position[2 * i + 1] <= 0 && i != model.rim) model.loads.unknown[2 * i] = -1;
  }
  // Numbers stay, so that the unknowns left out need an equation: renumber.
  std::vector<int> number(model.meridian.reference.size() + 1, -1);
  int count = 1;
  for (int& u : model.loads.unknown) {
    if (u <= 0) continue;
    if (number[u] < 0) number[u] = count++;
    u = number[u];
  }
}

double contact_radius(const EggModel& model, const VectorXd& position) {
  double radius = 0;
  for (int i = 0; i < model.rim; ++i) {
    if (position[2 * i + 1] <= 0) radius = std::max(radius, position[2 * i]);
  }
  return model.loads.plate_stiffness > 0 ? radius : 0;
}

double energy_of(const EggModel& model, const VectorXd& position) {
  const MembraneLaw& law = model.meridian.law;
  if (!law.has_energy()) return std::numeric_limits<double>::quiet_NaN();
  const VectorXd& home = model.meridian.reference;
  double sum = 0;
  for (int e = 0; e + 1 < model.meridian.nodes(); ++e) {
    const MeridianStretch s = stretch_at(model.meridian, position, e);
    const double length = (home.segment<2>(2 * e + 2) - home.segment<2>(2 * e)).norm();
    sum += M_PI * (home[2 * e] + home[2 * e + 2]) * length * stored_energy(law, s.along, s.around);
  }
  return sum;
}

IndentedEggState describe(const EggModel& model, const MeridianState& state) {
  const VectorXd& x = state.position;
  const int rim = model.rim, last = model.meridian.nodes() - 1;
  const double face = x[2 * rim + 1];
  IndentedEggState s;
  s.force = -model.loads.force;
  s.displacement = model.touch - face;
  s.pressure = state.pressure;
  s.volume_change = -state.pressure / model.loads.bulk_modulus;
  s.rim_stretch = stretch_at(model.meridian, x, rim - 1).along;
  s.rim_angle = std::atan2(x[2 * rim - 1] - face, x[2 * rim - 2] - x[2 * rim]);
  s.contact_radius = contact_radius(model, x);
  s.bulge = last > rim ? x[2 * last + 1] - face : 0;
  s.strain_energy = energy_of(model, x);
  s.shape = state;
  s.reference = model.meridian.reference;
  return s;
}

/// From a sphere somewhat larger than the egg, which has tension everywhere, to the egg under a
/// small force. All of the law is unwrinkled.
MeridianState first_contact(EggModel& model, double force) {
  // Small enough that its pressure does not lift the face of the pipette.
  const double face = model.meridian.reference[2 * model.rim] / (0.1 * 0.5 * model.touch);
  const double growth = 1 + 0.05 / std::max(1.0, face * face);
  const double fluid = model.loads.volume;
  model.loads.unwrinkled_share = 1;
  MeridianState state = inflated(model, growth);
  state.pressure = sphere_pressure(model.meridian.law, 0.5 * model.touch, growth);
  const auto deflate = [&](double done, MeridianLoads& loads) {
    loads.force = -force;
    loads.volume = fluid * std::pow(1 + (growth - 1) * (1 - done), 3);
  };
  deflate(0, model.loads);
  find_equilibrium(model.meridian, model.loads, state);
  follow_equilibrium(model.meridian, model.loads, state, deflate, 0.1);
  return state;
}

/// Lets the membrane wrinkle, step by step, where it carried compression.
MeridianState wrinkled(const EggModel& model, MeridianState state) {
  if (model.meridian.law.wrinkling == Wrinkling::none) return state;
  MeridianLoads loads = model.loads;
  const auto release = [](double done, MeridianLoads& at) {
    at.unwrinkled_share = std::pow(least_share, done);
  };
  follow_equilibrium(model.meridian, loads, state, release, 0.1);
  return state;
}

}  // namespace

IndentedEgg egg_of_the_source() {
  return {30e-6, {17.9e3, 0.49, 4.5e-6}, 3e-6, 2.5e-6};
}

double stiffened_gas_bulk_modulus(double grueneisen, double p_infinity) {
  require_positive(p_infinity, "P_inf");
  return (grueneisen + 1) * p_infinity;
}

std::vector<IndentedEggState> indent_egg(const IndentedEgg& egg, const std::vector<double>& forces,
                                         int elements) {
  check(egg, forces, elements);
  EggModel model = build(egg, elements);
  const MembraneLaw& law = egg.membrane;
  const double stride = 0.02 * law.youngs_modulus * law.thickness * egg.radius;
  double reached = std::min(forces.front(), stride);
  MeridianState state = first_contact(model, reached);
  std::vector<IndentedEggState> states;
  for (double target : forces) {
    const double from = reached;
    const int strides = static_cast<int>(std::ceil((target - from) / stride));
    for (int i = 1; i <= strides; ++i) {
      if (egg.support == EggSupport::sticking_plate) stick(model, state.position);
      const double next = from + (target - from) * i / strides;
      const auto press = [&](double done, MeridianLoads& loads) {
        loads.force = -(reached + done * (next - reached));
      };
      follow_equilibrium(model.meridian, model.loads, state, press, 1);
      reached = next;
    }
    states.push_back(describe(model, wrinkled(model, state)));
  }
  return states;
}

}  // namespace zona::studies::references
