#include "mpm/materials/von_mises_solid.h"

#include <Eigen/Eigenvalues>

#include "mpm/materials/bifurcation.h"

namespace zona::mpm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int row[6] = {0, 1, 2, 0, 1, 2};
constexpr int column[6] = {0, 1, 2, 1, 2, 0};

Matrix3d matrix_of(const SymmetricTensorLanes& tensor, int lane) {
  Matrix3d m;
  for (int c = 0; c < 6; ++c) m(row[c], column[c]) = m(column[c], row[c]) = tensor[c][lane];
  return m;
}

Matrix3d spin_of(const VelocityGradient& gradient, int lane) {
  Matrix3d l;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) l(i, j) = gradient[i][j][lane];
  }
  return 0.5 * (l - l.transpose());
}

/// sigma : C^-1 : sigma / 2 [J/m^3]
double elastic_energy(const Matrix3d& s, const ElasticModuli& e) {
  const double trace = s.trace();
  return ((1 + e.poisson_ratio) * s.squaredNorm() - e.poisson_ratio * trace * trace) /
         (2 * e.youngs_modulus);
}

}  // namespace

SolidState<VonMises>::SolidState(const VonMises& law, int points)
    : internal(points, 0.0),
      strength(points, law.yield_strength),
      dissipated(points, 0.0),
      surfaces(law.decohesion ? points : 0) {
  check(law);
}

void SolidState<VonMises>::correct(const PointGroup& group, const LaneMask& beyond,
                                   SymmetricTensorLanes& trial, const VelocityGradient& gradient,
                                   double dt, const ElasticModuli& moduli, const VonMises& law) {
  for (int l = 0; l < group.count(); ++l) {
    if (!beyond[l]) continue;
    const int p = group[l];
    Matrix3d stress = matrix_of(trial, l);
    const bool had_surface = !surfaces.empty() && surfaces.surface(p).present();
    if (had_surface) {
      turn_normal(p, dt * spin_of(gradient, l));
    } else {
      flow(p, stress, moduli, law);
    }
    if (!surfaces.empty() && surfaces.surface(p).present()) {
      open(p, stress, moduli, *law.decohesion);
    }
    for (int c = 0; c < 6; ++c) trial[c][l] = stress(row[c], column[c]);
  }
}

void SolidState<VonMises>::flow(int p, Stress& stress, const ElasticModuli& moduli,
                                const VonMises& law) {
  const double before = elastic_energy(stress, moduli);
  const Matrix3d spherical = stress.trace() / 3 * Matrix3d::Identity();
  const Matrix3d deviator = stress - spherical;
  const double trial = std::sqrt(1.5) * deviator.norm();
  if (!(trial > strength[p])) return;  // exceeded by rounding only
  const double stiffness = radial_stiffness(moduli.shear());
  PlasticFlow flow = return_along(law, trial, internal[p], stiffness);
  const double softening_begins = std::max(internal[p], law.peak_strain());
  const double at_most = law.strength(softening_begins);
  if (law.decohesion && internal[p] + flow.increment > softening_begins && at_most > 0 &&
      localise(p, spherical + at_most / trial * deviator, moduli, law)) {
    flow.increment = softening_begins - internal[p];
    flow.equivalent_stress = trial - stiffness * flow.increment;
  }
  stress = spherical + flow.equivalent_stress / trial * deviator;
  internal[p] += flow.increment;
  strength[p] = law.strength(internal[p]);
  dissipated[p] += before - elastic_energy(stress, moduli);
}

bool SolidState<VonMises>::localise(int p, const Stress& on_surface, const ElasticModuli& moduli,
                                    const VonMises& law) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(on_surface);
  const Vector3d descending = principal.eigenvalues().reverse();
  const Bifurcation found = bifurcation(descending, moduli);
  if (!loses_ellipticity(-law.softening_modulus, found, moduli)) return false;
  const Vector3d normal = std::cos(found.angle) * principal.eigenvectors().col(2) +
                          std::sin(found.angle) * principal.eigenvectors().col(0);
  const Vector3d traction = on_surface * normal;
  const double along_normal = normal.dot(traction);
  surfaces.start(
      p, surface_at(*law.decohesion, {along_normal, (traction - along_normal * normal).norm()}));
  for (int c = 0; c < 3; ++c) surfaces.normal[c][p] = normal[c];
  return true;
}

void SolidState<VonMises>::open(int p, Stress& stress, const ElasticModuli& moduli,
                                const Decohesion& law) {
  if (surfaces.failed(p)) return stress.setZero(), void();
  const double before = elastic_energy(stress, moduli);
  const Vector3d normal(surfaces.normal[0][p], surfaces.normal[1][p], surfaces.normal[2][p]);
  const double length = effective_length(normal, law.cell);
  for (int i = 0; i < max_decohesion_updates; ++i) {
    if (!open_once(p, stress, normal, length, moduli, law)) break;
  }
  if (surfaces.failed(p)) stress.setZero();
  surfaces.dissipated[p] += length * (before - elastic_energy(stress, moduli));
}

bool SolidState<VonMises>::open_once(int p, Stress& stress, const Vector3d& normal, double length,
                                     const ElasticModuli& moduli, const Decohesion& law) {
  const Vector3d traction = stress * normal;
  const double along_normal = normal.dot(traction);
  const Vector3d along_surface = traction - along_normal * normal;
  const auto [direction, effective] =
      decohesion_flow(law, surfaces.surface(p), {along_normal, along_surface.norm()});
  const double relief = (moduli.constrained() * direction.normal * direction.normal +
                         moduli.shear() * direction.tangential * direction.tangential) /
                        length;
  const double at_axis = direction.tangential > 0 ? along_surface.norm() * length /
                                                        (moduli.shear() * direction.tangential)
                                                  : HUGE_VAL;
  const double grown = decohesion_increment(law, surfaces.surface(p), surfaces.opened[p], effective,
                                            relief, at_axis);
  surfaces.opened[p] += grown;
  const Vector3d m = direction.normal * normal + direction.tangential * along_surface.normalized();
  stress -= grown / length *
            (moduli.lame_first() * direction.normal * Matrix3d::Identity() +
             moduli.shear() * (normal * m.transpose() + m * normal.transpose()));
  return grown > 0 && !surfaces.failed(p);
}

void SolidState<VonMises>::turn_normal(int p, const Eigen::Matrix3d& turn) {
  Vector3d normal(surfaces.normal[0][p], surfaces.normal[1][p], surfaces.normal[2][p]);
  normal = (normal + turn * normal).normalized();
  for (int c = 0; c < 3; ++c) surfaces.normal[c][p] = normal[c];
}

}  // namespace zona::mpm
