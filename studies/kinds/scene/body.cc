#include "studies/kinds/scene/body.h"

#include <fmt/format.h>

#include <cmath>

#include "studies/input/with_key.h"
#include "studies/kinds/scene/body_table.h"
#include "studies/kinds/scene/fluid_table.h"
#include "studies/kinds/scene/motion_table.h"
#include "studies/parameters/material_tables.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;

/// Values of a formula at places, problems reported at its key.
std::vector<double> values_at(const Table& table, const std::string& key, const Formula& formula,
                              const std::vector<Vector3d>& places) {
  return with_key(table.study(), key, [&] {
    std::vector<double> values;
    values.reserve(places.size());
    for (const Vector3d& place : places) values.push_back(formula.at(place));
    return values;
  });
}

/// Places of points with the size [m^3] or [m^2] that each stands for.
struct Pieces {
  std::vector<Vector3d> places;
  std::vector<double> sizes;
};

void check_places(const Table& table, const mpm::BackgroundGrid& grid, const Pieces& pieces) {
  const auto refuse = [&](const std::string& message) {
    throw InputError(table.problem(&BodyShape::shape, message));
  };
  if (pieces.places.empty()) {
    refuse("holds no point; make it larger, the cells smaller, or points_per_cell greater");
  }
  for (const Vector3d& x : pieces.places) {
    if (grid.cell_at(x.x(), x.y(), x.z())[0] >= 0) continue;
    refuse(
        fmt::format("a point at ({:g}, {:g}, {:g}) m lies outside the grid, which holds its lower "
                    "faces but not its upper ones; enlarge the grid by a cell",
                    x.x(), x.y(), x.z()));
  }
}

mpm::MaterialPoints points_of(const Table& table, const Pieces& pieces,
                              const std::vector<double>& mass) {
  mpm::MaterialPoints points = mpm::make_points(pieces.places, mass);
  const auto velocity = table.read<BodyMotion>().velocity;
  for (std::size_t axis = 0; axis < velocity.size(); ++axis) {
    const auto values =
        values_at(table, table.key(&BodyMotion::velocity), velocity[axis], pieces.places);
    std::copy(values.begin(), values.end(), points.velocity[axis].begin());
  }
  return points;
}

/// One density and pressure for a body that may not be uniform: the least density, and the pressure
/// with the greatest sound speed, to be on the safe side.
void choose_representative(mpm::FluidProperties& p, const std::vector<double>& density,
                           const std::vector<double>& pressure) {
  double fastest = 0;
  p.density = *std::min_element(density.begin(), density.end());
  for (std::size_t i = 0; i < density.size(); ++i) {
    const double stiffness = (pressure[i] + p.state.p_infinity) / density[i];
    if (stiffness <= fastest) continue;
    fastest = stiffness;
    const bool same = density[i] == p.density;
    p.pressure = same ? pressure[i] : stiffness * p.density - p.state.p_infinity;
  }
}

mpm::Fluid fluid_of(const Table& table, const Pieces& pieces, const std::vector<double>& density) {
  const auto described = table.read<SceneFluid>();
  const auto pressure =
      values_at(table, table.key(&SceneFluid::pressure), *described.pressure, pieces.places);
  mpm::FluidProperties properties = described.properties();
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    if (pressure[p] + properties.state.p_infinity > 0) continue;
    const Vector3d& x = pieces.places[p];
    throw InputError(
        table.problem(&SceneFluid::pressure,
                      fmt::format("{:g} Pa at ({:g}, {:g}, {:g}) m have no sound speed; needs more "
                                  "than {:g} Pa",
                                  pressure[p], x.x(), x.y(), x.z(), -properties.state.p_infinity)));
  }
  choose_representative(properties, density, pressure);
  mpm::Fluid fluid(properties, static_cast<int>(density.size()));
  double mass = 0, energy = 0;
  for (std::size_t p = 0; p < density.size(); ++p) {
    fluid.density[p] = density[p];
    fluid.internal_energy[p] = properties.state.internal_energy(pressure[p], density[p]);
    for (int c = 0; c < 3; ++c) fluid.stress[c][p] = -pressure[p];
    mass += density[p] * pieces.sizes[p];
    energy += density[p] * pieces.sizes[p] * fluid.internal_energy[p];
  }
  fluid.initial_energy = energy / mass;
  return fluid;
}

template <class Law>
mpm::Material solid_with(const Law& law, const SceneBody& body,
                         const std::vector<double>& density) {
  const mpm::ElasticProperties properties{*std::min_element(density.begin(), density.end()),
                                          body.youngs_modulus, body.poisson_ratio};
  mpm::Solid<Law> solid(properties, static_cast<int>(density.size()), law);
  std::copy(density.begin(), density.end(), solid.density.begin());
  return solid;
}

mpm::VonMises plasticity_of(const Table& table, const SceneBody& body,
                            const mpm::BackgroundGrid& grid) {
  return plastic_law(table, body.law == LawName::decohesion, grid.cell_size());
}

mpm::Material solid_of(const Table& table, const SceneBody& body, const mpm::BackgroundGrid& grid,
                       const std::vector<double>& density) {
  switch (body.law) {
    case LawName::elastic:
      return solid_with(mpm::Elastic{}, body, density);
    case LawName::elastodamage:
      return solid_with(table.read<mpm::Elastodamage>(), body, density);
    case LawName::von_mises:
    case LawName::decohesion:
      break;
  }
  return solid_with(plasticity_of(table, body, grid), body, density);
}

mpm::MembraneLaw membrane_law(const Table& table, const SceneBody& body,
                              const mpm::BackgroundGrid& grid) {
  switch (body.law) {
    case LawName::elastic:
      return table.read<MembraneOptions>().elastic_law();
    case LawName::elastodamage:
      return table.read<mpm::Elastodamage>();
    case LawName::von_mises:
    case LawName::decohesion:
      break;
  }
  return plasticity_of(table, body, grid);
}

double constant_density(const Table& table, const SceneBody& body) {
  const auto density = body.density->constant();
  if (density) return *density;
  throw InputError(table.problem(&SceneBody::density,
                                 "a membrane or rigid body has one density; needs a constant"));
}

mpm::Body membrane_body(const Table& table, const SceneBody& body,
                        const mpm::BackgroundGrid& grid) {
  const WeightedSurface weighted = surface_points(table.read<BodyShape>(), grid);
  const Pieces pieces{weighted.surface.places, weighted.areas};
  check_places(table, grid, pieces);
  const auto options = table.read<MembraneOptions>();
  const mpm::MembraneProperties properties{constant_density(table, body), body.thickness,
                                           body.youngs_modulus, body.poisson_ratio,
                                           options.one_way};
  std::vector<double> mass;
  for (double area : weighted.areas) {
    mass.push_back(properties.density * properties.thickness * area);
  }
  const mpm::MaterialPoints points = points_of(table, pieces, mass);
  mpm::Membrane membrane(properties, membrane_law(table, body, grid),
                         options.kinematics == MembraneKinematics::objective, points,
                         weighted.surface.triangles);
  return {table.name(), points, std::move(membrane), {}};
}

}  // namespace

mpm::Body scene_body(const Table& table, const mpm::BackgroundGrid& grid, const Inside& inside,
                     const Inside& cut) {
  const auto body = table.read<SceneBody>();
  if (body.material == MaterialName::membrane) return membrane_body(table, body, grid);
  const mpm::Lattice lattice = volume_points(table.read<BodyShape>(), grid, inside, cut);
  const Pieces pieces{lattice.places, lattice.volumes};
  check_places(table, grid, pieces);
  const auto density =
      values_at(table, table.key(&SceneBody::density), *body.density, pieces.places);
  std::vector<double> mass;
  for (std::size_t p = 0; p < density.size(); ++p) mass.push_back(density[p] * pieces.sizes[p]);
  const mpm::MaterialPoints points = points_of(table, pieces, mass);
  if (body.material == MaterialName::rigid) {
    const mpm::Drive drive = table.read<BodyMotion>().drive;
    return {table.name(),
            points,
            mpm::Prescribed(points, constant_density(table, body), {}, drive),
            {}};
  }
  mpm::Body result{table.name(),
                   points,
                   body.material == MaterialName::solid
                       ? solid_of(table, body, grid, density)
                       : mpm::Material(fluid_of(table, pieces, density)),
                   {}};
  result.average_volume_strain = body.average_volume_strain;
  return result;
}

}  // namespace zona::studies
