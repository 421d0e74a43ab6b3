#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/input/keys.h"
#include "studies/kinds/scene/parameters.h"
#include "studies/kinds/scene/shape.h"
#include "studies/parameters/box.h"
#include "studies/parameters/material_parameters.h"
#include "studies/parameters/shared_parameters.h"

namespace zona::studies {

namespace {

const char axis_name[] = {'x', 'y', 'z'};

double norm(const std::vector<double>& v) {
  return std::hypot(v[0], v[1], v[2]);
}

void check_grid(const Configuration& study, const Complain& complain) {
  const auto low = study.quantities("grid.low"), high = study.quantities("grid.high");
  const auto cell = study.quantities("grid.cell");
  double cells = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = high[axis] - low[axis];
    const double count = extent / cell[axis];
    if (!(extent > 0)) {
      complain("grid.high", fmt::format("{} = {:g} m is not above grid.low, {:g} m",
                                        axis_name[axis], high[axis], low[axis]));
      return;
    }
    if (std::abs(count - std::round(count)) > 1e-6 || count < 0.5) {
      complain(
          "grid.cell",
          fmt::format("the grid is {:g} m along {}, {:g} cells of {:g} m; needs a whole number, "
                      "e.g. cells of {:g} m",
                      extent, axis_name[axis], count, cell[axis],
                      extent / std::max(1.0, std::round(count))));
      return;
    }
    cells *= count;
  }
  if (cells > 5e7) {
    complain("grid.cell", fmt::format("{:g} cells; at most 5e7 are allowed", cells));
  }
}

void check_time(const Configuration& study, const Complain& complain) {
  if (!study.is_auto("time.step")) check_steps("time.step", "time.end", study, complain);
}

void check_material_fits_shape(const Table& body, const Complain& complain) {
  const std::string& shape = body.choice("shape");
  const bool membrane = body.choice("material") == "membrane";
  if (membrane && !is_surface(shape)) {
    complain("material",
             fmt::format("a membrane is a surface, a {} is not; needs shape = \"sheet\", "
                         "\"disc\" or \"icosphere\"",
                         shape));
  } else if (!membrane && is_surface(shape)) {
    complain("material", fmt::format("a {} is a surface; needs material = \"membrane\"", shape));
  }
}

void check_tube(const Table& body, const Complain& complain) {
  if (body.applies("from")) {
    auto along = body.quantities("to");
    const auto from = body.quantities("from");
    for (int axis = 0; axis < 3; ++axis) along[axis] -= from[axis];
    if (!(norm(along) > 0)) complain("to", "is the same place as from; needs another");
  }
  if (body.applies("inner_radius") &&
      body.quantity("inner_radius") >= body.quantity("outer_radius")) {
    complain("inner_radius",
             fmt::format("{:g} m is not less than outer_radius, {:g} m",
                         body.quantity("inner_radius"), body.quantity("outer_radius")));
  }
}

void check_sheet(const Table& body, const Complain& complain) {
  if (!body.applies("edge_u")) return;
  const auto u = body.quantities("edge_u"), v = body.quantities("edge_v");
  const std::vector<double> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                   u[0] * v[1] - u[1] * v[0]};
  if (norm(normal) > 1e-9 * norm(u) * norm(v)) return;
  complain("edge_v", "has no length or runs along edge_u; needs another direction");
}

void check_points(const Table& body, const Complain& complain) {
  if (!body.applies("points_per_cell")) return;
  const auto cell = body.study().quantities("grid.cell");
  const auto low = body.study().quantities("grid.low"), high = body.study().quantities("grid.high");
  const auto per_cell = body.integers("points_per_cell");
  double points = 1;
  for (int axis = 0; axis < 3; ++axis) {
    points *= (high[axis] - low[axis]) / cell[axis] * static_cast<double>(per_cell[axis]);
  }
  if (points > 2e9) {
    complain("points_per_cell", fmt::format("a full grid would have {:g} points; at most 2e9 are "
                                            "allowed",
                                            points));
  }
}

void check_plasticity(const Table& body, const Complain& complain) {
  if (!body.applies("yield_strength")) return;
  const Complain by_leaf = [&](const std::string& key, const std::string& message) {
    complain(leaf(key), message);
  };
  check_von_mises(body.key(""), body.study(), by_leaf);
}

void check_load(const Table& load, const Complain& complain) {
  check_box(load, complain, false);
  for (const Table& body : load.study().items("body")) {
    if (body.name() != load.text("body")) continue;
    const std::string& material = body.choice("material");
    if (material == "rigid") {
      complain("body", fmt::format("{} is rigid and moves as prescribed whatever acts on it; load "
                                   "another",
                                   body.name()));
    } else if (load.choice("kind") == "pressure" && material != "membrane") {
      complain("body",
               fmt::format("{} is no membrane; a pressure acts on membranes only", body.name()));
    }
  }
}

}  // namespace

void check_scene(Schema& schema) {
  schema.check(check_grid);
  schema.check(check_time);
  schema.check_each("body", [](const Table& body, const Complain& complain) {
    check_box(body, complain, false);
  });
  schema.check_each("body", check_material_fits_shape);
  schema.check_each("body", check_tube);
  schema.check_each("body", check_sheet);
  schema.check_each("body", check_points);
  schema.check_each("body", check_plasticity);
  schema.check_each(
      "hold", [](const Table& hold, const Complain& complain) { check_box(hold, complain, true); });
  schema.check_each("load", check_load);
}

}  // namespace zona::studies
