#include "studies/kinds/scene/case.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "studies/input/with_key.h"
#include "studies/kinds/scene/actions.h"
#include "studies/kinds/scene/body.h"
#include "studies/kinds/scene/body_table.h"
#include "studies/kinds/scene/boundary_table.h"
#include "studies/kinds/scene/gravity_table.h"
#include "studies/kinds/scene/grid_table.h"
#include "studies/kinds/scene/time_table.h"
#include "studies/measures/profiles.h"
#include "studies/parameters/time_step.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;

void add_bodies(const Configuration& study, mpm::Model& model) {
  const std::vector<Table> tables = study.items<SceneBody>();
  std::map<std::string, Inside> inside;
  for (const Table& table : tables)
    inside[table.name()] = inside_of(table.read<BodyShape>(), model.grid);
  for (const Table& table : tables) {
    std::vector<Inside> others;
    for (const std::string& name : table.read<BodyShape>().outside)
      others.push_back(inside.at(name));
    const Inside cut = [&](const Vector3d& place) {
      return std::any_of(others.begin(), others.end(), [&](const Inside& f) { return f(place); });
    };
    model.bodies.push_back(with_key(study, table.key(&SceneBody::material), [&] {
      return scene_body(table, model.grid, inside.at(table.name()), cut);
    }));
  }
}

}  // namespace

SceneCase make_scene_case(const Configuration& study) {
  const double end = study.value(&SceneTime::end);
  mpm::Model model{study.read<SceneGrid>().grid(),
                   {},
                   study.read<SceneBoundary>().faces(),
                   study.value(&Gravity::acceleration)};
  model.numerics = study.read<mpm::Numerics>();
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
      "{:.0f} points; {:.0f} steps of {:.4g} s, {:.2f} of the critical step, bound by {}; {:.3g} "
      "point-steps",
      points, steps, scene.step.seconds, scene.step.seconds / scene.step.critical,
      scene.step.binding, points * steps);
  return {text, points * steps};
}

}  // namespace zona::studies
