#include "mpm/step/solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mpm/points/errors.h"
#include "mpm/step/stages.h"

namespace zona::mpm {

namespace {

/// Steps between two sorts of the storage; points cross a cell in thousands of steps.
constexpr long sort_interval = 200;
/// Steps before each sort in which the time of each brick is measured, to redistribute the bricks.
constexpr long timed_steps = 10;

std::vector<std::vector<int>> nodes_held(const Model& model) {
  std::vector<std::vector<int>> nodes;
  for (const auto& held : model.held) nodes.push_back(nodes_in(model.grid, held.region));
  return nodes;
}

}  // namespace

Solver::Solver(Model model, double step, int threads)
    : model_(std::move(model)),
      loads_(model_.forces, model_.pressures, model_.bodies),
      held_nodes_(nodes_held(model_)),
      damping_(model_.numerics.damping, model_.grid, model_.faces, model_.held, held_nodes_),
      dt_(step),
      threads_(threads),
      schedule_(model_.grid, std::max(threads, 1)),
      driven_nodes_(model_.bodies.size()) {
  const CriticalStep critical =
      critical_step(model_.grid, model_.bodies, model_.numerics.implicit_pressure);
  if (!(step > 0)) throw ModelError(fmt::format("the time step must be positive, got {} s", step));
  if (step > critical.seconds) {
    throw ModelError(
        fmt::format("a step of {:.4g} s is above the critical step of {:.4g} s: in '{}', {}", step,
                    critical.seconds, critical.body, critical.reason));
  }
  if (const double pic = model_.numerics.pic; !(pic >= 0 && pic <= 1))
    throw ModelError(fmt::format("the fraction of PIC must lie in [0, 1], got {}", pic));
  if (model_.numerics.implicit_pressure && model_.numerics.damping > 0) {
    throw ModelError(
        "local damping of forces needs explicit pressure: forces of an implicit one are known only "
        "after the velocities");
  }
  if (threads < 1) throw ModelError(fmt::format("at least one thread is needed, got {}", threads));
  for (auto& body : model_.bodies) prepare(body);
  if (model_.numerics.implicit_pressure) {
    pressure_.emplace(model_.grid, model_.bodies, model_.numerics.pressure_tolerance, dt_, threads);
  }
  schedule_.share(estimated_costs());
  scatter();
}

void Solver::prepare(Body& body) {
  if (body.average_volume_strain && !body.can_average()) {
    throw ModelError(
        fmt::format("body '{}' has no volumetric strain that could be averaged", body.name));
  }
  const int outside = body.cells.build(model_.grid, body.points.position);
  if (outside >= 0) fail_at(body, outside, "a point lies outside the grid");
  body.sort_points();
  if (auto* rigid = std::get_if<Prescribed>(&body.material)) {
    const RigidState start = rigid->state(0);
    for (int axis = 0; axis < 3; ++axis) {
      std::fill(body.points.velocity[axis].begin(), body.points.velocity[axis].end(),
                start.velocity[axis]);
    }
    rigid->brick_impulse.resize(model_.grid.bricks().size());
  }
}

void Solver::step() {
  StageClock clock(stage_seconds_);
  prescribe_motion();
  add_loads();  // (5.51)
  clock.mark(Stage::loads);
  advance_momentum();  // (3.33)
  clock.mark(Stage::advance);
  if (pressure_) solve_pressure();
  clock.mark(Stage::pressure);
  hold_moved_nodes();
  clock.mark(Stage::advance);
  gather_and_map_back();  // (3.34)-(3.38)
  clock.mark(Stage::gather);
  finish_nodes();  // (3.39)
  clock.mark(Stage::finish);
  update_unfused();
  clock.mark(Stage::update);
  update_membranes();
  clock.mark(Stage::surface);
  index_moved_points();
  clock.mark(Stage::index);
  update_and_scatter();  // (3.40)-(3.42), then (3.30)-(3.32) of the next step
  clock.mark(Stage::scatter);
  ++steps_;
  if (steps_ % sort_interval == sort_interval - timed_steps) schedule_.start_timing();
  if (steps_ % sort_interval == 0) {
    sort_points();
    if (schedule_.is_timing()) schedule_.share(schedule_.stop_timing());
  }
  clock.mark(Stage::reorder);
}

void Solver::visit_state(StateVisitor& visitor) {
  visitor.visit("steps", steps_);
  for (std::size_t h = 0; h < model_.held.size(); ++h) {
    visitor.visit(fmt::format("held/{}/reaction", h), model_.held[h].reaction);
    visitor.visit(fmt::format("held/{}/power", h), model_.held[h].power);
  }
  for (auto& body : model_.bodies) body.visit_state(visitor);
  if (pressure_) pressure_->visit_state(visitor);
  if (!visitor.is_restoring()) return;
  for (auto& body : model_.bodies) {
    const int outside = body.cells.build(model_.grid, body.points.position);
    if (outside >= 0) fail_at(body, outside, "a restored point lies outside the grid");
  }
  schedule_.share(estimated_costs());
  scatter();
}

std::vector<double> Solver::estimated_costs() const {
  // Cost of a cell's nodes, which every stage reads and writes, in units of the cost of a point.
  constexpr double cost_of_cell = 2;
  std::vector<double> cost(model_.grid.bricks().size(), 1.0);
  for (std::size_t b = 0; b < cost.size(); ++b) {
    for (const auto& body : model_.bodies) {
      const BrickPoints& points = body.cells.brick(static_cast<int>(b));
      cost[b] += static_cast<double>(points.points.size());
      for (int c = 0; c < Brick::cell_count; ++c) {
        if (points.begin[c] < points.begin[c + 1]) cost[b] += cost_of_cell;
      }
    }
  }
  return cost;
}

void Solver::prescribe_motion() {
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    auto* rigid = std::get_if<Prescribed>(&model_.bodies[b].material);
    if (!rigid) continue;
    rigid->next = rigid->state((steps_ + 1) * dt_);
    if (rigid->drive == Drive::nodes) {
      driven_nodes_[b] = touched_nodes(model_.grid, model_.bodies[b].cells);
    }
  }
}

void Solver::scatter() {
  std::fill(model_.grid.state.begin(), model_.grid.state.end(), Lanes{});
  std::fill(model_.grid.updated.begin(), model_.grid.updated.end(), HalfLanes{});
  schedule_.in_order([this](int b) {
    for (auto& body : model_.bodies) scatter_brick(body, b, model_.grid);
  });
}

void Solver::add_loads() {
  if (loads_.empty()) return;
  loads_.evaluate(time());
  schedule_.in_order([this](int b) { loads_.add_brick(model_.bodies, b, model_.grid); });
}

void Solver::advance_momentum() {
  auto& grid = model_.grid;
  absorb_at_faces(grid, model_.faces, pressure_.has_value());
  const auto nodes = static_cast<long>(grid.node_count());
  const Lanes gravity{0, 0, 0, 0, model_.gravity.x(), model_.gravity.y(), model_.gravity.z(), 0};
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (long n = 0; n < nodes; ++n) {
    grid.updated[n] = HalfLanes{};
    Lanes& node = grid.state[n];
    const double mass = node[0];
    if (!(mass > smallest_nodal_mass)) {
      node = Lanes{};
      continue;
    }
    node += mass * gravity;
    const HalfLanes force = high_half(dt_ * node);
    const Lanes impulse =
        join(__builtin_shufflevector(force, HalfLanes{}, 4, 0, 1, 2), HalfLanes{});
    node = (node + impulse) * (1 / mass);
    node[0] = mass;
  }
}

void Solver::solve_pressure() {
  auto& grid = model_.grid;
  NodalFlow& flow = pressure_->flow;
  flow.take(grid, model_.faces, model_.bodies, time(), dt_, threads_);
  for (std::size_t h = 0; h < held_nodes_.size(); ++h) {
    const HeldNodes& held = model_.held[h];
    for (const int node : held_nodes_[h]) {
      const Eigen::Vector3d v = velocity_of(held, time() + dt_, grid, node);
      for (int axis = 0; axis < 3; ++axis) {
        if (held.axes[axis]) flow.hold(grid, node, axis, v[axis]);
      }
    }
  }
  for (std::size_t b = 0; b < driven_nodes_.size(); ++b) {
    const Prescribed* rigid = model_.bodies[b].prescribed();
    for (const int node : driven_nodes_[b]) {
      for (int axis = 0; axis < 3; ++axis) flow.hold(grid, node, axis, rigid->next.velocity[axis]);
    }
  }
  flow.push(grid, pressure_->solve(model_.bodies, steps_ + 1), dt_, threads_);
}

void Solver::hold_moved_nodes() {
  auto& grid = model_.grid;
  hold_faces(grid, model_.faces);
  for (std::size_t h = 0; h < held_nodes_.size(); ++h) {
    hold_nodes(grid, held_nodes_[h], model_.held[h], time(), dt_, model_.numerics.pic);
  }
  for (std::size_t b = 0; b < driven_nodes_.size(); ++b) {
    auto* rigid = std::get_if<Prescribed>(&model_.bodies[b].material);
    if (!rigid) continue;
    rigid->reaction = override_velocity(grid, driven_nodes_[b], rigid->next.velocity, dt_) / dt_;
  }
  damping_.apply(grid, model_.bodies, dt_, threads_);
}

void Solver::gather_and_map_back() {
  for (auto& body : model_.bodies) std::swap(body.points.position, body.points.last_position);
  schedule_.in_order([this](int b) {
    for (auto& body : model_.bodies) {
      if (!body.cells.brick(b).empty())
        gather_brick(body, b, dt_, model_.numerics.pic, model_.grid);
    }
  });
  for (auto& body : model_.bodies) {
    auto* rigid = std::get_if<Prescribed>(&body.material);
    if (!rigid) continue;
    for (std::size_t b = 0; b < rigid->brick_impulse.size(); ++b) {
      if (!body.cells.brick(static_cast<int>(b)).empty())
        rigid->reaction += rigid->brick_impulse[b] / dt_;
    }
  }
}

void Solver::finish_nodes() {
  auto& grid = model_.grid;
  const auto nodes = static_cast<long>(grid.node_count());
#pragma omp parallel for num_threads(threads_) schedule(static)
  for (long n = 0; n < nodes; ++n) {
    const double mass = grid.state[n][0];
    grid.updated[n] *= mass > smallest_nodal_mass ? 1 / mass : 0.0;
    grid.state[n] = Lanes{};
  }
  hold_updated_faces(grid, model_.faces);
  for (std::size_t h = 0; h < held_nodes_.size(); ++h) {
    hold_updated_nodes(grid, held_nodes_[h], model_.held[h], time() + dt_);
  }
  for (std::size_t b = 0; b < driven_nodes_.size(); ++b) {
    if (const auto* rigid = model_.bodies[b].prescribed()) {
      override_updated_velocity(grid, driven_nodes_[b], rigid->next.velocity);
    }
  }
}

void Solver::update_unfused() {
  schedule_.in_any_order([this](int b) {
    for (auto& body : model_.bodies) {
      if (!body.cells.brick(b).empty())
        record_invalid_points(body, update_brick(body, b, dt_, model_.grid));
    }
  });
}

void Solver::update_membranes() {
  for (auto& body : model_.bodies) {
    if (auto* membrane = std::get_if<Membrane>(&body.material)) {
      membrane->update_stress(body.points.position, (steps_ + 1) * dt_, threads_);
    }
  }
}

void Solver::index_moved_points() {
  for (auto& body : model_.bodies) {
    const int lost = body.cells.move_departed(model_.grid, body.points.position);
    if (lost < 0) continue;
    const bool finite = body.points.position_of(lost).allFinite();
    fail_at(body, lost, finite ? "a point left the grid" : "a position is not finite");
  }
}

void Solver::update_and_scatter() {
  schedule_.in_order([this](int b) {
    for (auto& body : model_.bodies) {
      if (!body.cells.brick(b).empty() || body.fluid_cells)
        record_invalid_points(body, update_and_scatter_brick(body, b, dt_, model_.grid));
    }
  });
  throw_if_invalid_points();
}

void Solver::record_invalid_points(const Body& body, const std::vector<int>& points) {
  if (points.empty()) return;
  const int number = static_cast<int>(&body - model_.bodies.data());
#pragma omp critical(zona_invalid_points)
  for (int p : points) invalid_points_.push_back({number, body.points.id[p]});
}

void Solver::throw_if_invalid_points() {
  if (invalid_points_.empty()) return;
  const auto first = *std::min_element(
      invalid_points_.begin(), invalid_points_.end(),
      [](auto& a, auto& b) { return std::pair(a.body, a.id) < std::pair(b.body, b.id); });
  const Body& body = model_.bodies[first.body];
  fail_at(body, body.points.storage_by_id()[first.id],
          "a point was compressed or expanded beyond what a step can describe");
}

void Solver::sort_points() {
  const int bodies = static_cast<int>(model_.bodies.size());
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 1)
  for (int b = 0; b < bodies; ++b) model_.bodies[b].sort_points();
}

long Solver::point_count() const {
  long count = 0;
  for (const auto& body : model_.bodies) count += body.points.size();
  return count;
}

const Body& Solver::body(const std::string& name) const {
  for (const auto& body : model_.bodies) {
    if (body.name == name) return body;
  }
  throw ModelError(fmt::format("there is no body '{}'", name));
}

void Solver::fail_at(const Body& body, int point, const std::string& what) const {
  throw PointError(what, body.name, body.points.id[point], body.points.position_of(point),
                   steps_ + 1, (steps_ + 1) * dt_);
}

}  // namespace zona::mpm
