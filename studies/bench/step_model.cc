#include "studies/bench/step_model.h"

#include <numeric>

namespace zona::studies::bench {

namespace {

/// Doubles of a point that a stage moves: `read`, `changed` in place, or only `written`.
struct Fields {
  double read, changed, written;
  double bytes() const { return 8 * (read + 2 * changed + 2 * written); }
};

struct Work {
  Fields fields;
  double flops;
};

// Trilinear functions. Operations of one point: the factors of its eight functions with three
// products, 72; one field interpolated, 14; nine derivatives, 75; a field to eight nodes, 16.
constexpr double factors = 72, interpolated = 14, derivatives = 75, to_nodes = 16;
constexpr double momentum_back = 3 * to_nodes + 3;
constexpr double state_to_nodes = 4 * to_nodes + 3;
constexpr double force_to_nodes = 9 * to_nodes + 12;

// Position at the start, velocity and mass give velocity and position.
constexpr Work gather{{4, 3, 3}, 6 * interpolated + 12 + factors + momentum_back};
constexpr Work driven_gather{{7, 3, 3}, 6 * interpolated + 12 + factors + momentum_back};
constexpr double shared_scatter = factors + state_to_nodes + force_to_nodes;
// Both positions, velocity, mass; then what the material has.
constexpr Work fluid_scatter{{10, 2, 6}, derivatives + 90 + shared_scatter};
constexpr Work solid_scatter{{10, 7, 0}, derivatives + 105 + shared_scatter};
// Position, velocity, mass and stress.
constexpr Work membrane_scatter{{13, 0, 0}, shared_scatter};
constexpr Work driven_scatter{{7, 0, 0}, factors + state_to_nodes};
constexpr Work membrane_update{{3, 6, 0}, derivatives + 21};
// Two triangles a point, of three vertices (ints) and a normal each; six triangles around a point
// (ints); the turned frame; strain, damage, stress and energy.
constexpr Work membrane_surface{{3 + 3 + 3 + 6 + 2 + 7, 6, 6 + 9 + 2}, 2 * 35 + 20 + 60 + 150};

// A node holds eight numbers and its updated velocity, four.
constexpr Fields advance_node{0, 8, 4}, gather_node{8, 4, 0}, finish_node{8, 4, 8},
    scatter_node{4, 8, 0};

}  // namespace

double StepModel::total_bytes() const {
  return std::accumulate(bytes.begin(), bytes.end(), 0.0);
}

double StepModel::total_flops() const {
  return std::accumulate(flops.begin(), flops.end(), 0.0);
}

StepModel step_model(const mpm::Solver& solver) {
  StepModel model;
  const auto add = [&](mpm::Stage stage, double count, const Work& work) {
    model.bytes[static_cast<int>(stage)] += count * work.fields.bytes();
    model.flops[static_cast<int>(stage)] += count * work.flops;
  };
  const auto nodes = static_cast<double>(solver.grid().node_count());
  add(mpm::Stage::advance, nodes, {advance_node, 30});
  add(mpm::Stage::gather, nodes, {gather_node, 0});
  add(mpm::Stage::finish, nodes, {finish_node, 4});
  add(mpm::Stage::scatter, nodes, {scatter_node, 0});
  for (const auto& body : solver.bodies()) {
    const double points = body.points.size();
    add(mpm::Stage::gather, points, body.prescribed() ? driven_gather : gather);
    if (body.membrane()) {
      add(mpm::Stage::update, points, membrane_update);
      add(mpm::Stage::surface, points, membrane_surface);
      add(mpm::Stage::scatter, points, membrane_scatter);
    } else if (body.prescribed()) {
      add(mpm::Stage::scatter, points, driven_scatter);
    } else {
      const bool fluid = std::holds_alternative<mpm::Fluid>(body.material);
      add(mpm::Stage::scatter, points, fluid ? fluid_scatter : solid_scatter);
    }
  }
  return model;
}

}  // namespace zona::studies::bench
