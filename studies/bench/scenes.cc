#include "studies/bench/scenes.h"

#include <cmath>

#include "studies/kinds/piercing/case.h"
#include "studies/kinds/piercing/schema.h"
#include "studies/parameters/fill_table.h"
#include "studies/program/bundled_studies.h"

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

/// The piercing of a bundled study, with changes as of `--set`.
PiercingSetup bundled(const std::string& name, const std::vector<std::string>& changes = {}) {
  const Configuration study =
      load_configuration(study_directory() / name, changes, {&piercing_schema()});
  return make_piercing_case(study, fills_of(study).front()).setup;
}

/// The zona alone, swelling.
mpm::Model membrane() {
  mpm::Model model = box_model(32);
  const Vector3d center = 0.5 * model.grid.upper_corner();
  const auto sphere = mpm::in_traversal_order(mpm::icosphere(center, 50e-6, 6), model.grid);
  const PiercingSetup::Zona zona = bundled("piercing_lateral.toml").zona;
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

/// The lateral piercing; domain and plate hold whole cells.
mpm::Model piercing(const std::string& cell, const std::string& domain, const std::string& plate,
                    const std::string& pressure = "explicit") {
  return build_piercing(
      bundled("piercing_lateral.toml",
              {"grid.cell=\"" + cell + "\"", "grid.domain=\"" + domain + "\"",
               "plate.side=\"" + plate + "\"", "numerics.pressure=\"" + pressure + "\""}));
}

}  // namespace

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all{
      {"fluid_27", "water, 27 points in each of 24^3 cells", true, [] { return fluid(24, 3); }},
      {"fluid_1", "water, one point in each of 64^3 cells", true, [] { return fluid(64, 1); }},
      {"solid", "an elastic solid, 27 points in each of 24^3 cells", true, solid},
      {"membrane", "the zona alone, 40962 points in cells of 4 um", true, membrane},
      {"piercing_9um", "a fill of the bundled comparison, cells of 9 um", true,
       [] { return build_piercing(bundled("piercing_lateral_quick.toml")); }},
      {"piercing_6um", "the lateral piercing, cells of 6 um", true,
       [] { return piercing("6 um", "150 um", "72 um"); }},
      {"piercing_5um", "the lateral piercing, cells of 5 um", false,
       [] { return piercing("5 um", "140 um", "70 um"); }},
      {"piercing_4um", "the lateral piercing, cells of 4 um", true,
       [] { return piercing("4 um", "128 um", "72 um"); }},
      {"implicit_6um", "the lateral piercing with implicit pressure, cells of 6 um", true,
       [] { return piercing("6 um", "150 um", "72 um", "implicit"); }, 3.5e-7},
      {"implicit_4um", "the lateral piercing with implicit pressure, cells of 4 um", true,
       [] { return piercing("4 um", "128 um", "72 um", "implicit"); }, 2.3e-7},
      {"piercing_3um", "the lateral piercing, cells of 3 um", false,
       [] { return piercing("3 um", "126 um", "72 um"); }},
      {"piercing_2.5um", "the lateral piercing, cells of 2.5 um", false,
       [] { return piercing("2.5 um", "125 um", "70 um"); }},
  };
  return all;
}

}  // namespace zona::studies::bench
