#include "studies/bench/scenes.h"

#include <cmath>

#include "studies/kinds/piercing/model.h"

namespace zona::studies::bench {

namespace {

using Eigen::Vector3d;

constexpr double cell = 4e-6;  // [m], as in the finest piercing of the source

mpm::Model box_model(int cells) {
  const auto closed = PiercingSetup::all_faces(mpm::FaceCondition::roller);
  return {mpm::BackgroundGrid(Vector3d::Zero(), Vector3d::Constant(cell), {cells, cells, cells}),
          {},
          closed};
}

/// Points everywhere in the box, moving at up to 0.1 m/s.
mpm::MaterialPoints moving_points(const mpm::BackgroundGrid& grid, int per_axis, double density) {
  const auto everywhere = [](const Vector3d&) { return true; };
  const auto lattice = mpm::fill_cells(grid, {per_axis, per_axis, per_axis}, everywhere);
  std::vector<double> mass;
  for (double volume : lattice.volumes) mass.push_back(density * volume);
  auto points = mpm::make_points(lattice.places, mass);
  const double wave = 2 * M_PI / (grid.upper_corner().x() - grid.origin().x());
  for (int p = 0; p < points.size(); ++p) {
    const Vector3d x = wave * points.position_of(p);
    points.velocity[0][p] = 0.1 * std::sin(x.x()) * std::cos(x.y());
    points.velocity[1][p] = -0.1 * std::cos(x.x()) * std::sin(x.y());
  }
  return points;
}

mpm::Model fluid(int cells, int per_axis) {
  mpm::Model model = box_model(cells);
  auto points = moving_points(model.grid, per_axis, 1000);
  mpm::Fluid water({1000, {4.0, 2.12e8}, 0, 8.9e-4, {}}, points.size());
  model.bodies.push_back({"water", std::move(points), std::move(water), {}});
  return model;
}

mpm::Model solid() {
  mpm::Model model = box_model(24);
  auto points = moving_points(model.grid, 3, 2300);
  mpm::LinearElastic glass({2300, 64e9, 0.2}, points.size());
  model.bodies.push_back({"glass", std::move(points), std::move(glass), {}});
  return model;
}

/// The zona alone, swelling.
mpm::Model membrane() {
  mpm::Model model = box_model(32);
  const Vector3d center = 0.5 * model.grid.upper_corner();
  const auto sphere = mpm::in_traversal_order(mpm::icosphere(center, 50e-6, 6), model.grid);
  const PiercingSetup::Zona zona;
  const double mass =
      4 * M_PI * 2.5e-9 * zona.membrane.thickness * zona.membrane.density / sphere.places.size();
  auto points = mpm::make_points(sphere.places, std::vector<double>(sphere.places.size(), mass));
  for (int p = 0; p < points.size(); ++p) {
    const Vector3d outward = (points.position_of(p) - center).normalized();
    for (int axis = 0; axis < 3; ++axis) points.velocity[axis][p] = 0.01 * outward[axis];
  }
  mpm::Membrane shell(zona.membrane, zona.law, zona.objective, points, sphere.triangles);
  model.bodies.push_back({"zona", std::move(points), std::move(shell), {}});
  return model;
}

/// The lateral piercing of 5.4 with the motion of the source.
mpm::Model driven(PiercingSetup setup) {
  setup.pipette.motion = [](double t) {
    const double amplitude = 13.5e-6, omega = 2 * M_PI / 100e-6;
    return mpm::RigidState{{0, amplitude * std::sin(omega * t), 0},
                           {0, amplitude * omega * std::cos(omega * t), 0}};
  };
  return build_piercing(setup);
}

/// Domain and plate hold whole cells.
mpm::Model piercing(double cell_size, double domain, double plate) {
  PiercingSetup setup;
  setup.cell = cell_size;
  setup.domain = domain;
  setup.plate.side = plate;
  return driven(setup);
}

/// As piercing_lateral_quick.toml and mercury_vs_water.toml.
mpm::Model small_piercing() {
  PiercingSetup setup;
  setup.cell = 9e-6;
  setup.domain = 153e-6;
  setup.zona.level = 5;
  setup.cytoplasm.points_per_cell = 8;
  setup.pipette.points = {2, 30, 15};
  return driven(setup);
}

}  // namespace

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all{
      {"fluid_27", "water, 27 points in each of 24^3 cells", true, [] { return fluid(24, 3); }},
      {"fluid_1", "water, one point in each of 64^3 cells", true, [] { return fluid(64, 1); }},
      {"solid", "an elastic solid, 27 points in each of 24^3 cells", true, solid},
      {"membrane", "the zona alone, 40962 points in cells of 4 um", true, membrane},
      {"piercing_9um", "a fill of the bundled comparison, cells of 9 um", true,
       [] { return small_piercing(); }},
      {"piercing_6um", "the lateral piercing, cells of 6 um", true,
       [] { return piercing(6e-6, 150e-6, 72e-6); }},
      {"piercing_5um", "the lateral piercing, cells of 5 um", false,
       [] { return piercing(5e-6, 140e-6, 70e-6); }},
      {"piercing_4um", "the lateral piercing, cells of 4 um", true,
       [] { return piercing(4e-6, 128e-6, 72e-6); }},
      {"piercing_3um", "the lateral piercing, cells of 3 um", false,
       [] { return piercing(3e-6, 126e-6, 72e-6); }},
      {"piercing_2.5um", "the lateral piercing, cells of 2.5 um", false,
       [] { return piercing(2.5e-6, 125e-6, 70e-6); }},
  };
  return all;
}

}  // namespace zona::studies::bench
