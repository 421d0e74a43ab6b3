#include "mpm/pressure/nodal_flow.h"

#include "mpm/grid/trilinear.h"

namespace zona::mpm {

namespace {

/// Calls f(node, place) for all nodes of a grid.
template <class F>
void for_each_node_and_place(const BackgroundGrid& grid, const CellLattice& lattice, int threads,
                             F f) {
  const auto& along = grid.nodes_along();
#pragma omp parallel for num_threads(threads) schedule(static) collapse(2)
  for (int k = 0; k < along[2]; ++k) {
    for (int j = 0; j < along[1]; ++j) {
      const int node = grid.node_index(0, j, k);
      const long place = lattice.place(0, j, k);
      for (int i = 0; i < along[0]; ++i) f(node + i, place + i);
    }
  }
}

long place_of(const BackgroundGrid& grid, const CellLattice& lattice, int node) {
  const auto& along = grid.nodes_along();
  const int layer = along[0] * along[1];
  return lattice.place(node % along[0], node % layer / along[0], node / layer);
}

/// Mass of the points of a cell at its nodes.
trilinear::VectorSums nodal_mass(const BackgroundGrid& grid, const Cell& cell,
                                 const MaterialPoints& points, const int* begin, const int* end) {
  trilinear::VectorSums sums(grid, cell);
  for_each_group(begin, end, [&](const PointGroup& group) {
    PointVectors at{};
    const auto natural = cell.natural(group.load(points.position));
    for (int axis = 0; axis < 3; ++axis) store(at.natural[axis], natural[axis]);
    store(at.vector[0], group.load(points.mass));
    for (int p = 0; p < group.count(); ++p) sums.add(at, p);
  });
  return sums;
}

}  // namespace

NodalFlow::NodalFlow(const CellLattice& lattice) : lattice_(lattice) {
  velocity.fill(Field(lattice.size, 0.0));
  mobility.fill(FloatField(lattice.size, 0.0f));
  inverse_mass = velocity;
}

void NodalFlow::add_prescribed(const BackgroundGrid& grid, const std::vector<Body>& bodies,
                               double time) {
  prescribed_.resize(grid.node_count());
  for (const int node : touched_) prescribed_[node] = HalfLanes{};
  touched_.clear();
  for (const Body& body : bodies) {
    const Prescribed* rigid = body.prescribed();
    if (!rigid) continue;
    const Eigen::Vector3d change = rigid->next.velocity - rigid->state(time).velocity;
    const HalfLanes gain{1, change.x(), change.y(), change.z()};
    for (int b = 0; b < body.cells.brick_count(); ++b) {
      for_each_cell(grid, b, body.cells.brick(b),
                    [&](const Cell& cell, const int* begin, const int* end, int) {
                      nodal_mass(grid, cell, body.points, begin, end)
                          .for_each_node(cell, grid, [&](int node, const HalfLanes& sum) {
                            prescribed_[node] += sum[0] * gain;
                            touched_.push_back(node);
                          });
                    });
    }
  }
}

void NodalFlow::take(BackgroundGrid& grid, const FaceConditions& faces,
                     const std::vector<Body>& bodies, double time, double dt, int threads) {
  add_prescribed(grid, bodies, time);
  for_each_node_and_place(grid, lattice_, threads, [&](int n, long place) {
    Lanes& state = grid.state[n];
    const double mass = state[0];
    const bool exists = mass > smallest_nodal_mass;
    const double free = exists ? 1 - prescribed_[n][0] / mass : 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (exists && prescribed_[n][0] > 0) {
        state[1 + axis] += (free - 1) * dt * state[4 + axis] + prescribed_[n][1 + axis] / mass;
      }
      velocity[axis][place] = state[1 + axis];
      inverse_mass[axis][place] = exists ? 1 / mass : 0.0;
      mobility[axis][place] = exists ? static_cast<float>(free / mass) : 0.0f;
    }
  });
  absorb(grid, faces, dt);
  for_each_held(grid, faces, [&](int node, int axis) { hold(grid, node, axis, 0); });
}

void NodalFlow::absorb(BackgroundGrid& grid, const FaceConditions& faces, double dt) {
  for (int face = 0; face < 6; ++face) {
    if (faces[face] != FaceCondition::absorbing) continue;
    const int normal = face / 2;
    for_each_node(grid, face, [&](int node) {
      Lanes& state = grid.state[node];
      if (!(state[0] > smallest_nodal_mass)) return;
      const long place = place_of(grid, lattice_, node);
      const double rate = 2 / grid.cell_size()[normal] * state[7] / state[0];
      const double left = 1 / (1 + dt * rate);
      state[4 + normal] -= left * rate * state[1 + normal];
      state[1 + normal] *= left;
      velocity[normal][place] = state[1 + normal];
      mobility[normal][place] *= static_cast<float>(left);
      inverse_mass[normal][place] *= left;
    });
  }
}

void NodalFlow::hold(const BackgroundGrid& grid, int node, int axis, double value) {
  const long place = place_of(grid, lattice_, node);
  velocity[axis][place] = value;
  mobility[axis][place] = 0;
}

void NodalFlow::push(BackgroundGrid& grid, const std::array<Field, 3>& force, double dt,
                     int threads) const {
  for_each_node_and_place(grid, lattice_, threads, [&](int n, long place) {
    Lanes& state = grid.state[n];
    for (int axis = 0; axis < 3; ++axis) {
      state[1 + axis] += dt * mobility[axis][place] * force[axis][place];
      state[4 + axis] += inverse_mass[axis][place] * force[axis][place];
    }
  });
}

}  // namespace zona::mpm
