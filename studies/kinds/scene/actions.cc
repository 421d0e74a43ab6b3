#include "studies/kinds/scene/actions.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/input/with_key.h"
#include "studies/kinds/scene/body_table.h"
#include "studies/kinds/scene/hold_table.h"
#include "studies/kinds/scene/load_table.h"
#include "studies/kinds/scene/motion_table.h"
#include "studies/kinds/scene/time_table.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;
using VectorOfTime = std::function<Vector3d(double)>;

/// Evaluates formulas of time at a thousand instants of the run, to report errors at their key
/// before it starts.
void try_out(const Configuration& study, const std::string& key,
             const std::vector<Formula>& formulas) {
  constexpr int instants = 1000;
  const double end = study.value(&SceneTime::end);
  with_key(study, key, [&] {
    for (const Formula& formula : formulas) {
      for (int i = 0; i <= instants; ++i) formula.at(end * i / instants);
    }
  });
}

bool all_zero(const std::vector<Formula>& formulas) {
  return std::all_of(formulas.begin(), formulas.end(),
                     [](const Formula& formula) { return formula.constant() == 0.0; });
}

/// Velocity of held nodes, tried out at every node of the region.
std::function<Vector3d(double, const Vector3d&)> velocity_field(const Table& table,
                                                                const std::vector<Formula>& f,
                                                                const mpm::BackgroundGrid& grid,
                                                                const mpm::Box& region) {
  const auto at = [f](double t, const Vector3d& x) {
    return Vector3d(f[0].at(x, t), f[1].at(x, t), f[2].at(x, t));
  };
  const double end = table.study().value(&SceneTime::end);
  with_key(table.study(), table.key(&Hold::velocity), [&] {
    for (const int node : mpm::nodes_in(grid, region)) {
      for (const double t : {0.0, end / 2, end}) at(t, grid.node_position(node));
    }
    for (int i = 0; i <= 1000; ++i) {
      at(end * i / 1000, grid.node_position(mpm::nodes_in(grid, region).front()));
    }
  });
  return at;
}

/// Formulas of a key, one per component.
VectorOfTime vector_of_time(const Configuration& study, const std::string& key,
                            const std::vector<Formula>& f) {
  try_out(study, key, f);
  return [f](double t) { return Vector3d(f[0].at(t), f[1].at(t), f[2].at(t)); };
}

mpm::BodyForce body_force(const Table& table, const Load& load, const mpm::BackgroundGrid& grid) {
  const bool total = load.kind == LoadKind::force;
  const VectorOfTime value =
      total ? vector_of_time(table.study(), table.key(&Load::force), load.force)
            : vector_of_time(table.study(), table.key(&Load::traction), load.traction);
  const double area = total ? 1 : load.area;
  return {load.body, load.in(grid),
          [value, area](double t) -> Vector3d { return area * value(t); }};
}

mpm::SurfacePressure surface_pressure(const Table& table, const Load& load) {
  const Formula pressure = *load.pressure;
  try_out(table.study(), table.key(&Load::pressure), {pressure});
  return {load.body, [pressure](double t) { return pressure.at(t); }};
}

/// The displacement and its slope, by differences of fourth order over a tenth of a step.
mpm::RigidMotion rigid_motion(const Table& table, double step) {
  const auto displacement = table.read<BodyMotion>().displacement;
  if (all_zero(displacement)) return {};
  const VectorOfTime at =
      vector_of_time(table.study(), table.key(&BodyMotion::displacement), displacement);
  if (const Vector3d start = at(0); start.norm() > 0) {
    throw InputError(table.problem(&BodyMotion::displacement,
                                   fmt::format("starts with ({:g}, {:g}, {:g}) m; it must be zero "
                                               "at t = 0",
                                               start.x(), start.y(), start.z())));
  }
  const double h = step / 10;
  return [at, h](double t) {
    const double middle = std::max(t, 2 * h);  // formulas have no meaning before the start
    const Vector3d slope =
        (8 * (at(middle + h) - at(middle - h)) - (at(middle + 2 * h) - at(middle - 2 * h))) /
        (12 * h);
    return mpm::RigidState{at(t), slope};
  };
}

/// The key of the lower corner of a table's box.
template <class T>
std::string box_key(const Table& table) {
  return table.key(static_cast<Vector3d T::*>(&BoxKeys::low));
}

}  // namespace

void add_holds(const Configuration& study, mpm::Model& model) {
  for (const Table& table : study.items<Hold>()) {
    const auto hold = table.read<Hold>();
    mpm::HeldNodes held;
    held.region = hold.in(model.grid);
    for (int axis = 0; axis < 3; ++axis) {
      held.axes[axis] = std::find(hold.axes.begin(), hold.axes.end(), axis) != hold.axes.end();
    }
    with_key(study, box_key<Hold>(table), [&] { return mpm::nodes_in(model.grid, held.region); });
    if (!all_zero(hold.velocity)) {
      held.velocity = velocity_field(table, hold.velocity, model.grid, held.region);
    }
    model.held.push_back(std::move(held));
  }
}

void add_loads(const Configuration& study, mpm::Model& model) {
  for (const Table& table : study.items<Load>()) {
    const auto load = table.read<Load>();
    if (load.kind == LoadKind::pressure) {
      model.pressures.push_back(surface_pressure(table, load));
      continue;
    }
    model.forces.push_back(body_force(table, load, model.grid));
    with_key(study, box_key<Load>(table),
             [&] { return mpm::Loads({model.forces.back()}, {}, model.bodies); });
  }
}

void set_rigid_motions(const Configuration& study, double step, mpm::Model& model) {
  const std::vector<Table> tables = study.items<SceneBody>();
  for (std::size_t b = 0; b < tables.size(); ++b) {
    auto* rigid = std::get_if<mpm::Prescribed>(&model.bodies[b].material);
    if (rigid != nullptr) rigid->motion = rigid_motion(tables[b], step);
  }
}

}  // namespace zona::studies
