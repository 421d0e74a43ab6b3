#include "studies/kinds/scene/case.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "studies/input/with_key.h"
#include "studies/kinds/scene/actions.h"
#include "studies/kinds/scene/body.h"
#include "studies/measures/profiles.h"
#include "studies/parameters/numerics_parameters.h"
#include "studies/parameters/time_step.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;

Vector3d vector_of(const std::vector<double>& v) {
  return {v[0], v[1], v[2]};
}

mpm::BackgroundGrid make_grid(const Configuration& study) {
  const Vector3d low = vector_of(study.quantities("grid.low"));
  const Vector3d high = vector_of(study.quantities("grid.high"));
  const Vector3d cell = vector_of(study.quantities("grid.cell"));
  std::array<int, 3> cells;
  for (int axis = 0; axis < 3; ++axis) {
    cells[axis] = static_cast<int>(std::lround((high[axis] - low[axis]) / cell[axis]));
  }
  return {low, cell, cells, interpolation_of(study.choice("grid.interpolation"))};
}

mpm::FaceConditions make_faces(const Configuration& study) {
  const char* names[6] = {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};
  mpm::FaceConditions faces{};
  for (int face = 0; face < 6; ++face) {
    faces[face] = face_condition(study.choice(std::string("boundary.") + names[face]));
  }
  return faces;
}

void add_bodies(const Configuration& study, mpm::Model& model) {
  const std::vector<Table> tables = study.items("body");
  std::map<std::string, Inside> inside;
  for (const Table& table : tables) inside[table.name()] = inside_of(table, model.grid);
  for (const Table& table : tables) {
    std::vector<Inside> others;
    if (table.applies("outside")) {
      for (const std::string& name : table.texts("outside")) others.push_back(inside.at(name));
    }
    const Inside cut = [&](const Vector3d& place) {
      return std::any_of(others.begin(), others.end(), [&](const Inside& f) { return f(place); });
    };
    model.bodies.push_back(with_key(study, table.key("material"), [&] {
      return scene_body(table, model.grid, inside.at(table.name()), cut);
    }));
  }
}

}  // namespace

SceneCase make_scene_case(const Configuration& study) {
  const double end = study.quantity("time.end");
  mpm::Model model{
      make_grid(study), {}, make_faces(study), vector_of(study.quantities("gravity.acceleration"))};
  model.numerics = numerics_from(study);
  add_bodies(study, model);
  add_holds(study, model);
  add_loads(study, model);
  check_sections(study, model.grid, Eigen::Vector3d::Zero());
  const TimeStep step = time_step(study, model, end);
  set_rigid_motions(study, step.seconds, model);
  return {study, std::move(model), step, end};
}

StudyCost scene_cost(const SceneCase& scene) {
  const auto& cells = scene.model.grid.cells();
  std::string text = fmt::format("grid of {} x {} x {} cells\n", cells[0], cells[1], cells[2]);
  double points = 0;
  for (const mpm::Body& body : scene.model.bodies) {
    const auto& mass = body.points.mass;
    points += body.points.size();
    text += fmt::format("{}: {} points, {:.6g} kg\n", body.name, body.points.size(),
                        std::accumulate(mass.begin(), mass.end(), 0.0));
  }
  const auto steps = static_cast<double>(step_count(scene.end, scene.step.seconds));
  text += fmt::format(
      "{:.0f} points; {:.0f} steps of {:.4g} s, {:.2f} of the critical step; {:.3g} point-steps",
      points, steps, scene.step.seconds, scene.step.seconds / scene.step.critical, points * steps);
  return {text, points * steps};
}

}  // namespace zona::studies
