#include "studies/kinds/scene/body.h"

#include <fmt/format.h>

#include <cmath>

#include "studies/input/with_key.h"
#include "studies/parameters/material_parameters.h"
#include "studies/parameters/numerics_parameters.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;

/// Values of a formula at places, problems told at its key.
std::vector<double> values_at(const Table& table, const std::string& key, const Formula& formula,
                              const std::vector<Vector3d>& places) {
  return with_key(table.study(), table.key(key), [&] {
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
    throw InputError(table.problem("shape", message));
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
  if (!table.applies("velocity")) return points;
  const std::vector<Formula> velocity = table.formulas("velocity");
  for (int axis = 0; axis < 3; ++axis) {
    const auto values = values_at(table, "velocity", velocity[axis], pieces.places);
    std::copy(values.begin(), values.end(), points.velocity[axis].begin());
  }
  return points;
}

mpm::FluidProperties fluid_properties(const Table& table) {
  mpm::FluidProperties p{};
  p.state = table.choice("material") == "gas"
                ? mpm::StiffenedGas::ideal_gas(table.number("gamma"))
                : mpm::StiffenedGas{table.number("grueneisen"), table.quantity("p_infinity")};
  p.shear_viscosity = table.quantity("viscosity");
  p.energy_increment = energy_increment_of(table.choice("energy_increment"));
  p.artificial_viscosity = {table.number("artificial_viscosity_quadratic"),
                            table.number("artificial_viscosity_linear")};
  return p;
}

/// Density and pressure that stand for the body where it is not uniform: the least density, and the
/// pressure that gives it the greatest sound speed, so that what follows from them is on the safe
/// side.
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
  const auto pressure = values_at(table, "pressure", table.formula("pressure"), pieces.places);
  mpm::FluidProperties properties = fluid_properties(table);
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    if (pressure[p] + properties.state.p_infinity > 0) continue;
    const Vector3d& x = pieces.places[p];
    throw InputError(table.problem(
        "pressure", fmt::format("{:g} Pa at ({:g}, {:g}, {:g}) m have no sound speed; needs more "
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
mpm::Material solid_with(const Law& law, const Table& table, const std::vector<double>& density) {
  const mpm::ElasticProperties properties{*std::min_element(density.begin(), density.end()),
                                          table.quantity("youngs_modulus"),
                                          table.number("poisson_ratio")};
  mpm::Solid<Law> solid(properties, static_cast<int>(density.size()), law);
  std::copy(density.begin(), density.end(), solid.density.begin());
  return solid;
}

/// von Mises, with decohesion where the law says so.
mpm::VonMises plasticity_of(const Table& table, const mpm::BackgroundGrid& grid) {
  mpm::VonMises plastic = von_mises_from(table, "");
  if (table.choice("law") == "decohesion") {
    plastic.decohesion = decohesion_from(table, "", grid.cell_size());
    if (table.applies("bifurcation")) {
      plastic.decohesion->localization = localization_of(table.choice("bifurcation"));
    }
  }
  return plastic;
}

mpm::Material solid_of(const Table& table, const mpm::BackgroundGrid& grid,
                       const std::vector<double>& density) {
  const std::string& law = table.choice("law");
  if (law == "elastic") return solid_with(mpm::Elastic{}, table, density);
  if (law == "elastodamage") return solid_with(elastodamage_from(table, ""), table, density);
  return solid_with(plasticity_of(table, grid), table, density);
}

mpm::MembraneLaw membrane_law(const Table& table, const mpm::BackgroundGrid& grid) {
  const std::string& law = table.choice("law");
  if (law == "elastodamage") return elastodamage_from(table, "");
  if (law != "elastic") return plasticity_of(table, grid);
  if (table.choice("stress_update") == "increments") return mpm::IncrementalElastic{};
  return mpm::Elastic{};
}

double constant_density(const Table& table) {
  const auto density = table.formula("density").constant();
  if (density) return *density;
  throw InputError(
      table.problem("density", "a membrane or rigid body has one density; needs a constant"));
}

mpm::Body membrane_body(const Table& table, const mpm::BackgroundGrid& grid) {
  const WeightedSurface weighted = surface_points(table, grid);
  const Pieces pieces{weighted.surface.places, weighted.areas};
  check_places(table, grid, pieces);
  const mpm::MembraneProperties properties{
      constant_density(table), table.quantity("thickness"), table.quantity("youngs_modulus"),
      table.number("poisson_ratio"), one_way_of(table.choice("one_way"))};
  std::vector<double> mass;
  for (double area : weighted.areas) {
    mass.push_back(properties.density * properties.thickness * area);
  }
  const mpm::MaterialPoints points = points_of(table, pieces, mass);
  mpm::Membrane membrane(properties, membrane_law(table, grid),
                         table.choice("kinematics") == "objective", points,
                         weighted.surface.triangles);
  return {table.name(), points, std::move(membrane), {}};
}

}  // namespace

mpm::Body scene_body(const Table& table, const mpm::BackgroundGrid& grid, const Inside& inside,
                     const Inside& cut) {
  const std::string& material = table.choice("material");
  if (material == "membrane") return membrane_body(table, grid);
  const mpm::Lattice lattice = volume_points(table, grid, inside, cut);
  const Pieces pieces{lattice.places, lattice.volumes};
  check_places(table, grid, pieces);
  const auto density = values_at(table, "density", table.formula("density"), pieces.places);
  std::vector<double> mass;
  for (std::size_t p = 0; p < density.size(); ++p) mass.push_back(density[p] * pieces.sizes[p]);
  const mpm::MaterialPoints points = points_of(table, pieces, mass);
  if (material == "rigid") {
    const auto drive = table.choice("drive") == "nodes" ? mpm::Drive::nodes : mpm::Drive::points;
    return {table.name(), points, mpm::Prescribed(points, constant_density(table), {}, drive), {}};
  }
  mpm::Body body{table.name(),
                 points,
                 material == "solid" ? solid_of(table, grid, density)
                                     : mpm::Material(fluid_of(table, pieces, density)),
                 {}};
  body.average_volume_strain = table.boolean("average_volume_strain");
  return body;
}

}  // namespace zona::studies
