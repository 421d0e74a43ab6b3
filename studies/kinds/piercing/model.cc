#include "studies/kinds/piercing/model.h"

#include <fmt/format.h>

#include <cmath>

#include "mpm/points/errors.h"

namespace zona::studies {

using Eigen::Vector3d;

namespace {

mpm::BackgroundGrid make_grid(const PiercingSetup& setup, const PiercingGeometry& geometry) {
  return {Vector3d::Zero(), Vector3d::Constant(setup.cell), geometry.cells, setup.interpolation};
}

bool in_wall(const mpm::Tube& tube, const Vector3d& place) {
  const Vector3d from_end = place - tube.end;
  const double along = from_end.dot(tube.axis);
  const double radius = (from_end - along * tube.axis).norm();
  return along >= 0 && along <= tube.length && radius >= tube.inner_radius &&
         radius <= tube.outer_radius;
}

bool in_box(const Vector3d& low, const Vector3d& high, const Vector3d& place) {
  return (place.array() >= low.array()).all() && (place.array() <= high.array()).all();
}

std::vector<double> masses(const mpm::Lattice& lattice, double density) {
  std::vector<double> mass;
  for (double volume : lattice.volumes) mass.push_back(density * volume);
  return mass;
}

mpm::Body fluid_body(const std::string& name, const PiercingSetup::FluidRegion& region,
                     const mpm::Lattice& lattice) {
  const auto points = mpm::make_points(lattice.places, masses(lattice, region.fluid.density));
  return {name, points, mpm::Fluid(region.fluid, points.size()), {}};
}

mpm::Body rigid_body(const std::string& name, const mpm::Lattice& lattice, double density,
                     const mpm::RigidMotion& motion, mpm::Drive drive) {
  const auto points = mpm::make_points(lattice.places, masses(lattice, density));
  return {name, points, mpm::Prescribed(points, density, motion, drive), {}};
}

/// Points per axis of a cube number of points per cell.
std::array<int, 3> per_axis(int points_per_cell) {
  const int n = static_cast<int>(std::lround(std::cbrt(points_per_cell)));
  if (n < 1 || n * n * n != points_per_cell) {
    throw mpm::ModelError(
        fmt::format("points per cell must be 1, 8, 27, 64, ..., got {}", points_per_cell));
  }
  return {n, n, n};
}

mpm::Body zona_body(const PiercingSetup& setup, const PiercingGeometry& geometry,
                    const mpm::BackgroundGrid& grid) {
  const auto& zona = setup.zona;
  const auto sphere = mpm::in_traversal_order(
      mpm::icosphere(geometry.egg_center, geometry.egg_radius, zona.level), grid);
  // s rho^m / N^P for each point (4.1).
  const double area = 4 * M_PI * geometry.egg_radius * geometry.egg_radius;
  const double mass = area * zona.membrane.thickness * zona.membrane.density / sphere.places.size();
  const auto points =
      mpm::make_points(sphere.places, std::vector<double>(sphere.places.size(), mass));
  mpm::Membrane membrane(zona.membrane, zona.law, zona.objective, points, sphere.triangles);
  return {"zona", points, std::move(membrane), {}};
}

}  // namespace

PiercingGeometry piercing_geometry(const PiercingSetup& setup) {
  PiercingGeometry g;
  const int cells = static_cast<int>(std::ceil(setup.domain / setup.cell - 1e-9));
  const double edge = cells * setup.cell;
  const double plate = setup.plate.present ? setup.plate.thickness_cells * setup.cell : 0;
  const double length = plate + setup.zona.diameter + setup.pipette.tip_length;
  const double width = std::max(setup.zona.diameter, setup.plate.present ? setup.plate.side : 0.0);
  if (length > edge || width > edge) {
    throw mpm::ModelError(
        fmt::format("plate, egg and tip are {:.4g} um long and {:.4g} um wide: they do not fit "
                    "into a domain of {:.4g} um",
                    length * 1e6, width * 1e6, edge * 1e6));
  }
  g.cells = {cells, cells, cells};
  g.egg_radius = setup.zona.diameter / 2;
  const double start = (edge - length) / 2;
  g.egg_center = {start + plate + g.egg_radius, edge / 2, edge / 2};
  const double half = setup.plate.side / 2;
  g.plate_low = {start, edge / 2 - half, edge / 2 - half};
  g.plate_high = {start + plate, edge / 2 + half, edge / 2 + half};
  g.tip = {g.egg_center + Vector3d(g.egg_radius, 0, 0), Vector3d::UnitX(), setup.pipette.tip_length,
           setup.pipette.inner_diameter / 2, setup.pipette.outer_diameter / 2};
  return g;
}

mpm::Model build_piercing(const PiercingSetup& setup) {
  const PiercingGeometry g = piercing_geometry(setup);
  mpm::Model model{make_grid(setup, g), {}, setup.faces, Vector3d::Zero()};
  model.numerics = setup.numerics;
  const auto in_egg = [&](const Vector3d& x) { return (x - g.egg_center).norm() < g.egg_radius; };
  const auto in_medium = [&](const Vector3d& x) {
    return !in_egg(x) && !in_wall(g.tip, x) &&
           !(setup.plate.present && in_box(g.plate_low, g.plate_high, x));
  };
  model.bodies.push_back(zona_body(setup, g, model.grid));
  model.bodies.push_back(
      fluid_body("cytoplasm", setup.cytoplasm,
                 mpm::fill_cells(model.grid, per_axis(setup.cytoplasm.points_per_cell), in_egg)));
  model.bodies.push_back(
      fluid_body("medium", setup.medium,
                 mpm::fill_cells(model.grid, per_axis(setup.medium.points_per_cell), in_medium)));
  for (auto& body : model.bodies) {
    body.average_volume_strain = setup.average_volume_strain && !body.membrane();
  }
  const auto& p = setup.pipette;
  model.bodies.push_back(rigid_body("pipette",
                                    mpm::tube(g.tip, p.points[0], p.points[1], p.points[2]),
                                    p.density, p.motion, p.drive));
  if (setup.plate.present) {
    const int across = static_cast<int>(std::lround(setup.plate.side / setup.cell));
    model.bodies.push_back(rigid_body(
        "plate", mpm::box(g.plate_low, g.plate_high, {setup.plate.thickness_cells, across, across}),
        setup.plate.density, {}, p.drive));
  }
  return model;
}

}  // namespace zona::studies
