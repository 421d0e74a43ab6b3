#include "studies/references/gas_box.h"

#include <algorithm>
#include <cmath>

#include "studies/references/displacement.h"
#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

using Eigen::Vector3d;
using Positions = TriangleMembrane::Positions;

/// Volume between a triangle and the plane z = 0 [m^3], and p times its gradient on the nodes.
double add_pressure(const std::array<int, 3>& t, const Positions& x, double p, Positions& force) {
  const Vector3d &a = x[t[0]], &b = x[t[1]], &c = x[t[2]];
  const double twice_area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  const double height = a[2] + b[2] + c[2];
  for (int i = 0; i < 3; ++i) {
    const Vector3d &next = x[t[(i + 1) % 3]], &last = x[t[(i + 2) % 3]];
    force[t[i]] +=
        p / 6 * Vector3d(height * (next[1] - last[1]), height * (last[0] - next[0]), twice_area);
  }
  return height * twice_area / 6;
}

double volume_under(const TriangleMembrane& membrane, const Positions& x) {
  double sum = 0;
  for (const auto& t : membrane.triangles()) {
    const Vector3d &a = x[t[0]], &b = x[t[1]], &c = x[t[2]];
    sum +=
        (a[2] + b[2] + c[2]) / 6 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
  }
  return sum;
}

void check(const GasBox& box, const GasBoxResolution& resolution) {
  require_positive(box.side, "side of the lid");
  require_positive(box.height, "height of the box");
  require_positive(box.pressure, "pressure");
  require(box.gamma > 1, "the ratio of specific heats exceeds 1, not " + std::to_string(box.gamma));
  require_positive(box.membrane_density, "density of the membrane");
  require_positive(box.cube_density, "density of the cube");
  require(box.cube_side > 0 && box.cube_side < box.side, "the cube is smaller than the lid");
  require_positive(resolution.end, "end time");
  require_positive(resolution.interval, "sampling interval");
  require(resolution.courant > 0 && resolution.courant <= 0.5,
          "the Courant number must be in (0, 0.5], not " + std::to_string(resolution.courant));
  const double lines = resolution.squares * box.cube_side / box.side;
  require(std::abs(lines - std::round(lines)) < 1e-9 && lines > 0.5,
          "the cube's edge must be a line of the mesh; take a number of squares other than " +
              std::to_string(resolution.squares));
}

/// The quarter x, y >= 0 of the lid: planes of symmetry at x = 0 and y = 0, held at x or y =
/// side/2.
class QuarterLid {
 public:
  QuarterLid(const GasBox& box, int squares);
  void step(double dt);
  GasBoxSample sample(double time) const;
  double largest_strain() const { return membrane_.largest_strain(); }

 private:
  QuarterLid(const GasBox& box, const SquareMesh& mesh);
  bool under_cube(int node) const { return cube_share_[node] > 0; }
  void find_forces();
  void kick(double dt);

  GasBox box_;
  TriangleMembrane membrane_;
  std::vector<double> mass_;        ///< of the membrane
  std::vector<double> cube_share_;  ///< share of the cube's footprint; 0 outside
  std::vector<std::array<bool, 3>> held_;
  Positions position_, before_, velocity_, force_;
  double volume_, pressure_;
};

QuarterLid::QuarterLid(const GasBox& box, int squares)
    : QuarterLid(box, square_mesh(0.5 * box.side, squares)) {}

QuarterLid::QuarterLid(const GasBox& box, const SquareMesh& mesh)
    : box_(box),
      membrane_(box.membrane, box.strain, mesh.nodes, mesh.triangles),
      mass_(membrane_.nodal_mass(box.membrane_density)),
      cube_share_(mesh.nodes.size(), 0.0),
      position_(mesh.nodes),
      before_(mesh.nodes),
      velocity_(mesh.nodes.size(), Vector3d::Zero()),
      force_(velocity_) {
  const double edge = 0.5 * box.cube_side * (1 + 1e-9), wall = 0.5 * box.side * (1 - 1e-9);
  for (const Vector3d& x : mesh.nodes) {
    const bool at_wall = x[0] > wall || x[1] > wall,
               glued = box.rigid_cube && x[0] < edge && x[1] < edge;
    held_.push_back({at_wall || glued || x[0] == 0, at_wall || glued || x[1] == 0, at_wall});
  }
  const double footprint = 0.25 * box.cube_side * box.cube_side;
  for (const auto& t : mesh.triangles) {
    const Vector3d middle = (mesh.nodes[t[0]] + mesh.nodes[t[1]] + mesh.nodes[t[2]]) / 3;
    if (middle[0] > edge || middle[1] > edge) continue;
    const double area = std::pow(0.5 * box.side, 2) / mesh.triangles.size();
    for (int node : t) cube_share_[node] += area / 3 / footprint;
  }
  find_forces();
}

void QuarterLid::find_forces() {
  const double at_rest = box_.side * box_.side * box_.height;
  volume_ = at_rest + 4 * volume_under(membrane_, position_);
  pressure_ = box_.pressure * std::pow(at_rest / volume_, box_.gamma);
  std::fill(force_.begin(), force_.end(), Vector3d::Zero());
  membrane_.add_forces(before_, position_, force_);
  for (const auto& t : membrane_.triangles()) add_pressure(t, position_, pressure_, force_);
  before_ = position_;
}

void QuarterLid::kick(double dt) {
  const double quarter = 0.25 * box_.cube_density * std::pow(box_.cube_side, 3);
  double cube_force = 0, cube_mass = quarter;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    if (under_cube(i)) {
      cube_force += force_[i][2];
      cube_mass += mass_[i];
    }
  }
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const bool glued = box_.rigid_cube && under_cube(i);
    const double loaded = mass_[i] + cube_share_[i] * quarter;
    for (int c = 0; c < 3; ++c) {
      if (!held_[i][c]) velocity_[i][c] += dt * force_[i][c] / loaded;
    }
    if (glued) velocity_[i][2] += dt * (cube_force / cube_mass - force_[i][2] / loaded);
  }
}

void QuarterLid::step(double dt) {
  kick(0.5 * dt);
  for (std::size_t i = 0; i < mass_.size(); ++i) position_[i] += dt * velocity_[i];
  find_forces();
  kick(0.5 * dt);
}

GasBoxSample QuarterLid::sample(double time) const {
  GasBoxSample s{time, 0, 0, pressure_, volume_, 0, 0, 4 * membrane_.energy(), 0};
  const double cube = box_.cube_density * std::pow(box_.cube_side, 3);
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    s.displacement += cube_share_[i] * position_[i][2];
    s.velocity += cube_share_[i] * velocity_[i][2];
    s.highest = std::max(s.highest, position_[i][2]);
    s.kinetic_energy += 0.5 * (4 * mass_[i] + cube_share_[i] * cube) * velocity_[i].squaredNorm();
  }
  s.gas_energy = pressure_ * volume_ / (box_.gamma - 1);
  return s;
}

}  // namespace

GasBox box_of_the_source() {
  const MembraneLaw membrane{1e5, 0.45, 0.01};
  return {0.2, 0.1, 800, 1.4, membrane, 1000, 0.04, 1000};
}

double GasBoxHistory::displacement(double time) const {
  return displacement_at(samples, time);
}

GasBoxHistory gas_box(const GasBox& box, const GasBoxResolution& resolution) {
  check(box, resolution);
  QuarterLid lid(box, resolution.squares);
  const double nu = box.membrane.poisson_ratio;
  const double wave =
      std::sqrt(box.membrane.youngs_modulus / ((1 - nu * nu) * box.membrane_density));
  const double critical = 0.5 * box.side / resolution.squares / wave;
  const int steps =
      static_cast<int>(std::ceil(resolution.interval / (resolution.courant * critical)));
  const double dt = resolution.interval / steps;
  const int samples = static_cast<int>(std::ceil(resolution.end / resolution.interval - 1e-9));
  GasBoxHistory history;
  history.samples.push_back(lid.sample(0));
  const double initial = history.samples[0].gas_energy;
  double work = 0, error = 0;
  for (int i = 0; i < samples; ++i) {
    for (int k = 0; k < steps; ++k) lid.step(dt);
    const GasBoxSample s = lid.sample((i + 1) * resolution.interval);
    require(std::isfinite(s.displacement), "the lid broke up: take a smaller Courant number");
    work = std::max(work, initial - s.gas_energy);
    error = std::max(error, std::abs(s.kinetic_energy + s.strain_energy + s.gas_energy - initial));
    history.largest_strain = std::max(history.largest_strain, lid.largest_strain());
    history.samples.push_back(s);
  }
  history.energy_error = error / work;
  return history;
}

double gas_inertia(double gas_density, double height, double lid_mass) {
  require_positive(lid_mass, "mass of the lid");
  const double added = gas_density * height / 3;
  return added / (lid_mass + added);
}

}  // namespace zona::studies::references
