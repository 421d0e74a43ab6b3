#include "studies/kinds/scene/actions.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/input/with_key.h"
#include "studies/kinds/scene/shape.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;
using VectorOfTime = std::function<Vector3d(double)>;

[[noreturn]] void refuse(const Table& table, const std::string& key, const std::string& message) {
  throw InputError(table.problem(key, message));
}

/// Evaluates formulas of time at a thousand instants of the run: what is wrong with them is told
/// before it starts.
void try_out(const Table& table, const std::string& key, const std::vector<Formula>& formulas) {
  constexpr int instants = 1000;
  const double end = table.study().quantity("time.end");
  with_key(table.study(), table.key(key), [&] {
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
                                                                const mpm::BackgroundGrid& grid,
                                                                const mpm::Box& region) {
  const std::vector<Formula> f = table.formulas("velocity");
  const auto at = [f](double t, const Vector3d& x) {
    return Vector3d(f[0].at(x, t), f[1].at(x, t), f[2].at(x, t));
  };
  const double end = table.study().quantity("time.end");
  with_key(table.study(), table.key("velocity"), [&] {
    for (const int node : mpm::nodes_in(grid, region)) {
      for (const double t : {0.0, end / 2, end}) at(t, grid.node_position(node));
    }
    for (int i = 0; i <= 1000; ++i) {
      at(end * i / 1000, grid.node_position(mpm::nodes_in(grid, region).front()));
    }
  });
  return at;
}

VectorOfTime vector_of_time(const Table& table, const std::string& key) {
  const std::vector<Formula> f = table.formulas(key);
  try_out(table, key, f);
  return [f](double t) { return Vector3d(f[0].at(t), f[1].at(t), f[2].at(t)); };
}

mpm::BodyForce body_force(const Table& table, const mpm::BackgroundGrid& grid) {
  const bool total = table.choice("kind") == "force";
  const VectorOfTime value = vector_of_time(table, total ? "force" : "traction");
  const double area = total ? 1 : table.quantity("area");
  return {table.text("body"), box_of(table, grid),
          [value, area](double t) -> Vector3d { return area * value(t); }};
}

mpm::SurfacePressure surface_pressure(const Table& table) {
  const Formula pressure = table.formula("pressure");
  try_out(table, "pressure", {pressure});
  return {table.text("body"), [pressure](double t) { return pressure.at(t); }};
}

/// The displacement and its slope, by differences of fourth order over a tenth of a step.
mpm::RigidMotion rigid_motion(const Table& table, double step) {
  if (all_zero(table.formulas("displacement"))) return {};
  const VectorOfTime at = vector_of_time(table, "displacement");
  if (const Vector3d start = at(0); start.norm() > 0) {
    refuse(table, "displacement",
           fmt::format("starts with ({:g}, {:g}, {:g}) m; it must be zero at "
                       "t = 0",
                       start.x(), start.y(), start.z()));
  }
  const double h = step / 10;
  return [at, h](double t) {
    const double middle = std::max(t, 2 * h);  // before the start a formula means nothing
    const Vector3d slope =
        (8 * (at(middle + h) - at(middle - h)) - (at(middle + 2 * h) - at(middle - 2 * h))) /
        (12 * h);
    return mpm::RigidState{at(t), slope};
  };
}

}  // namespace

void add_holds(const Configuration& study, mpm::Model& model) {
  for (const Table& table : study.items("hold")) {
    mpm::HeldNodes held;
    held.region = box_of(table, model.grid);
    const std::vector<std::string> axes = table.texts("axes");
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name(1, static_cast<char>('x' + axis));
      held.axes[axis] = std::find(axes.begin(), axes.end(), name) != axes.end();
    }
    with_key(study, table.key("low"), [&] { return mpm::nodes_in(model.grid, held.region); });
    if (!all_zero(table.formulas("velocity"))) {
      held.velocity = velocity_field(table, model.grid, held.region);
    }
    model.held.push_back(std::move(held));
  }
}

void add_loads(const Configuration& study, mpm::Model& model) {
  for (const Table& table : study.items("load")) {
    if (table.choice("kind") == "pressure") {
      model.pressures.push_back(surface_pressure(table));
      continue;
    }
    model.forces.push_back(body_force(table, model.grid));
    with_key(study, table.key("low"),
             [&] { return mpm::Loads({model.forces.back()}, {}, model.bodies); });
  }
}

void set_rigid_motions(const Configuration& study, double step, mpm::Model& model) {
  const std::vector<Table> tables = study.items("body");
  for (std::size_t b = 0; b < tables.size(); ++b) {
    auto* rigid = std::get_if<mpm::Prescribed>(&model.bodies[b].material);
    if (rigid != nullptr) rigid->motion = rigid_motion(tables[b], step);
  }
}

}  // namespace zona::studies
