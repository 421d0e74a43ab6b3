#include "studies/references/axisymmetric_membrane.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>

#include "studies/references/meridian_element.h"
#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;
using Eigen::VectorXd;

Vector4d element_of(const VectorXd& x, int e) {
  return x.segment<4>(2 * e);
}

/// The linearised equations: unknowns of the membrane, then the pressure if a fluid sets it.
class System {
 public:
  System(const Meridian& meridian, const MeridianLoads& loads)
      : meridian_(meridian), loads_(loads), membrane_(loads.unknowns()) {
    size_ = membrane_ + (loads.filled ? 1 : 0);
  }

  void assemble(const MeridianState& state);
  VectorXd step();
  const VectorXd& residual() const { return residual_; }
  /// Residual forces over E h R, residual volume over the volume.
  double error() const;
  void apply(const VectorXd& step, double share, MeridianState& state) const;

 private:
  void add_element(int e, const MeridianState& state);
  void add_plate(int node, const VectorXd& x);
  void add(int row, int column, double value) {
    if (row >= 0 && column >= 0) entries_.emplace_back(row, column, value);
  }

  const Meridian& meridian_;
  const MeridianLoads& loads_;
  int membrane_, size_;
  std::vector<Eigen::Triplet<double>> entries_;
  VectorXd residual_;
};

void System::add_element(int e, const MeridianState& state) {
  const Vector4d now = element_of(state.position, e);
  const Vector4d reference = element_of(meridian_.reference, e);
  const ElementStrain strain = meridian_.summed
                                   ? strain_of_sum(state.summed[e], element_of(state.last, e), now)
                                   : strain_of_stretches(meridian_.law.strain, reference, now);
  const ElementForces f =
      element_forces(meridian_.law, loads_.unwrinkled_share, reference, now, strain);
  const ElementQuantity v = element_volume(now);
  const Vector4d force = f.force - state.pressure * v.gradient;
  const Matrix4d stiffness = f.stiffness - state.pressure * v.second;
  for (int i = 0; i < 4; ++i) {
    const int row = loads_.unknown[2 * e + i];
    if (row < 0) continue;
    residual_[row] += force[i];
    for (int j = 0; j < 4; ++j) add(row, loads_.unknown[2 * e + j], stiffness(i, j));
    if (!loads_.filled) continue;
    add(row, membrane_, -v.gradient[i]);
    add(membrane_, row, v.gradient[i]);
  }
}

void System::add_plate(int node, const VectorXd& x) {
  const int row = loads_.unknown[2 * node + 1];
  const double depth = -x[2 * node + 1];
  if (row < 0 || depth <= 0) return;
  const VectorXd& home = meridian_.reference;
  double area = 0;  // undeformed, half of the elements on both sides
  for (int e : {node - 1, node}) {
    if (e < 0 || e + 1 >= meridian_.nodes()) continue;
    const Vector4d r = element_of(home, e);
    area += 0.5 * M_PI * (r[0] + r[2]) * (r.tail<2>() - r.head<2>()).norm();
  }
  residual_[row] -= loads_.plate_stiffness * area * depth;
  add(row, row, loads_.plate_stiffness * area);
}

void System::assemble(const MeridianState& state) {
  entries_.clear();
  residual_ = VectorXd::Zero(size_);
  for (int e = 0; e + 1 < meridian_.nodes(); ++e) add_element(e, state);
  if (loads_.plate_stiffness > 0) {
    for (int n = 0; n < meridian_.nodes(); ++n) add_plate(n, state.position);
  }
  if (loads_.loaded >= 0) residual_[loads_.loaded] -= loads_.force;
  if (loads_.filled) {
    residual_[membrane_] = enclosed_volume(state.position) -
                           loads_.volume * (1 - state.pressure / loads_.bulk_modulus);
    add(membrane_, membrane_, loads_.volume / loads_.bulk_modulus);
  }
}

double System::error() const {
  const double size = meridian_.reference.cwiseAbs().maxCoeff();
  const double scale = meridian_.law.youngs_modulus * meridian_.law.thickness * size;
  const double forces = residual_.head(membrane_).cwiseAbs().maxCoeff() / scale;
  return loads_.filled ? std::max(forces, std::abs(residual_[membrane_]) / loads_.volume) : forces;
}

VectorXd System::step() {
  // Unknowns are metres and pascals: pressures in units of E h/size^2 keep the pivots comparable.
  const double size = meridian_.reference.cwiseAbs().maxCoeff();
  const double unit = meridian_.law.youngs_modulus * meridian_.law.thickness / (size * size);
  VectorXd scale = VectorXd::Ones(size_);
  if (loads_.filled) scale[membrane_] = unit;
  Eigen::SparseMatrix<double> matrix(size_, size_);
  matrix.setFromTriplets(entries_.begin(), entries_.end());
  const Eigen::SparseMatrix<double> balanced = scale.asDiagonal() * matrix * scale.asDiagonal();
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(balanced);
  require(solver.info() == Eigen::Success,
          "the membrane has lost its stiffness: " + solver.lastErrorMessage());
  const VectorXd scaled = solver.solve(VectorXd(scale.cwiseProduct(-residual_)));
  return scale.cwiseProduct(scaled);
}

void System::apply(const VectorXd& step, double share, MeridianState& state) const {
  for (int i = 0; i < state.position.size(); ++i) {
    const int u = loads_.unknown[i];
    if (u >= 0) state.position[i] += share * step[u];
  }
  if (loads_.filled) state.pressure += share * step[membrane_];
}

/// The largest share of the step that changes no element by more than half of its length.
double admissible(const System& system, const VectorXd& step, const MeridianState& state) {
  MeridianState moved = state;
  system.apply(step, 1, moved);
  double share = 1;
  for (int e = 0; 2 * e + 4 <= state.position.size(); ++e) {
    const Vector4d before = element_of(state.position, e), after = element_of(moved.position, e);
    const Eigen::Vector2d span = before.tail<2>() - before.head<2>();
    const Eigen::Vector2d change = after.tail<2>() - after.head<2>() - span;
    share = std::min(share, 0.5 * span.norm() / std::max(change.norm(), 1e-300));
  }
  return share;
}

/// Accepts an equilibrium: adds the strain increments since the last one.
void keep(const Meridian& meridian, MeridianState& state) {
  for (int e = 0; meridian.summed && e + 1 < meridian.nodes(); ++e) {
    state.summed[e] =
        summed_strain(state.summed[e], element_of(state.last, e), element_of(state.position, e));
  }
  state.last = state.position;
}

}  // namespace

int MeridianLoads::unknowns() const {
  return 1 + *std::max_element(unknown.begin(), unknown.end());
}

double enclosed_volume(const VectorXd& position) {
  double sum = 0;
  for (int e = 0; 2 * e + 4 <= position.size(); ++e) {
    sum += element_volume(element_of(position, e)).value;
  }
  return sum;
}

MeridianStretch stretch_at(const Meridian& meridian, const VectorXd& position, int element) {
  const Vector4d reference = element_of(meridian.reference, element);
  const Vector4d now = element_of(position, element);
  const double length = (reference.tail<2>() - reference.head<2>()).norm();
  return {(now.tail<2>() - now.head<2>()).norm() / length,
          (now[0] + now[2]) / (reference[0] + reference[2])};
}

int find_equilibrium(const Meridian& meridian, const MeridianLoads& loads, MeridianState& state) {
  check(meridian.law);
  require(loads.unknown.size() == static_cast<std::size_t>(meridian.reference.size()) &&
              state.position.size() == meridian.reference.size(),
          "a meridian's coordinates, unknowns and positions are equally many");
  if (!loads.filled) state.pressure = loads.pressure;
  if (state.last.size() == 0) {
    state.last = meridian.reference;
    state.summed.assign(meridian.nodes() - 1, Vector4d::Zero());
  }
  System system(meridian, loads);
  system.assemble(state);
  for (int iteration = 1; iteration <= 60; ++iteration) {
    const VectorXd step = system.step();
    const VectorXd before = state.position;
    const double pressure = state.pressure, error = system.error();
    double share = admissible(system, step, state);
    // Halve the step while the error grows much; keep the last try, because wrinkling makes kinks.
    for (int halving = 0; halving < 6; ++halving, share *= 0.5) {
      state.position = before;
      state.pressure = pressure;
      system.apply(step, share, state);
      system.assemble(state);
      if (system.error() < 2 * error) break;
    }
    if (system.error() < 1e-12) {
      keep(meridian, state);
      return iteration;
    }
  }
  throw mpm::ModelError("the membrane finds no equilibrium; residual " +
                        std::to_string(system.error()) + " of E h R. Take smaller load steps");
}

void follow_equilibrium(const Meridian& meridian, MeridianLoads& loads, MeridianState& state,
                        const std::function<void(double, MeridianLoads&)>& set, double first_step) {
  double done = 0, step = first_step;
  while (done < 1) {
    const double next = std::min(1.0, done + step);
    MeridianState trial = state;
    set(next, loads);
    try {
      find_equilibrium(meridian, loads, trial);
    } catch (const mpm::ModelError&) {
      step *= 0.5;
      if (step < first_step / 4096) throw;
      continue;
    }
    state = trial;
    done = next;
    step = std::min(1.5 * step, first_step);
  }
}

}  // namespace zona::studies::references
