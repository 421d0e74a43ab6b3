#include "mpm/membranes/von_mises_membrane.h"

#include <algorithm>

#include "mpm/materials/bifurcation.h"

namespace zona::mpm {

namespace {

using Frame = Eigen::Matrix<double, 3, 2>;

/// Elastic stress of a point and its derivatives with respect to the strain.
struct ElasticPoint {
  PrincipalValues<double> strain;
  PrincipalValues<double> stress;
  bool one_axis;       ///< wrinkled: the second principal strain has no effect
  double first_axis;   ///< d first stress / d first strain [Pa]
  double second_axis;  ///< d second stress / d first strain [Pa]

  ElasticPoint(const PlaneTensor& elastic, const MembraneProperties& p)
      : strain(principal(elastic)),
        stress(one_way_stress(strain, p)),
        one_axis(p.one_way == OneWay::stress   ? stress.second == 0
                 : p.one_way == OneWay::strain ? strain.second <= 0
                                               : false),
        first_axis(one_axis && p.one_way == OneWay::stress ? p.youngs_modulus
                                                           : p.moduli().plane_stress()),
        second_axis(one_axis && p.one_way == OneWay::stress
                        ? 0
                        : p.poisson_ratio * p.moduli().plane_stress()) {}

  double energy() const {
    return 0.5 * (stress.first * strain.first + stress.second * strain.second);
  }
  /// Change of the stress for a change `a` of the elastic strain, both along the principal axes.
  PlaneTensor stress_change(const PlaneTensor& a) const {
    const double along_second = one_axis ? 0 : a.yy;
    const double turning = strain.first > strain.second
                               ? (stress.first - stress.second) / (strain.first - strain.second)
                               : first_axis - second_axis;
    return {first_axis * a.xx + second_axis * along_second,
            second_axis * a.xx + first_axis * along_second, turning * a.xy};
  }
};

/// Transforms a tensor from principal axes to the local frame.
PlaneTensor from_axes(const PlaneTensor& a, const PrincipalValues<double>& axes) {
  const double mean = 0.5 * (a.xx + a.yy);
  const double half = 0.5 * (a.xx - a.yy);
  const double along = half * axes.cos2 - a.xy * axes.sin2;
  return {mean + along, mean - along, a.xy * axes.cos2 + half * axes.sin2};
}

/// Transforms a tensor from the local frame to principal axes.
PlaneTensor to_axes(const PlaneTensor& a, const PrincipalValues<double>& axes) {
  return from_axes(a, {axes.first, axes.second, axes.cos2, -axes.sin2});
}

Eigen::Vector2d times(const PlaneTensor& a, const Eigen::Vector2d& v) {
  return {a.xx * v.x() + a.xy * v.y(), a.xy * v.x() + a.yy * v.y()};
}

/// Plastic flow under tension along one axis, where the second principal stress is a fixed fraction
/// of the first: equivalent stress and flow direction N of (5.17) per unit of the first.
struct OneAxisFlow {
  double equivalent;
  double first, second;  ///< N

  explicit OneAxisFlow(double fraction)
      : equivalent(std::sqrt(1 - fraction + fraction * fraction)),
        first((2 - fraction) / (std::sqrt(6.0) * equivalent)),
        second((2 * fraction - 1) / (std::sqrt(6.0) * equivalent)) {}
};

}  // namespace

MembraneState<VonMises>::MembraneState(const VonMises& l, int points)
    : law(l),
      internal(points, 0.0),
      strength(points, l.yield_strength),
      dissipated(points, 0.0),
      surfaces(l.decohesion ? points : 0) {
  check(l);
  for (auto& component : inelastic_strain) component.assign(points, 0.0);
}

MembraneResponse MembraneState<VonMises>::respond(const PointGroup& group, const LocalStrain& local,
                                                  const Principal&, const MembraneProperties& p,
                                                  MembraneIntegrity& integrity) {
  const auto inelastic = group.load(inelastic_strain);
  InPlane elastic = local.strain - InPlane{inelastic[0], inelastic[1], inelastic[2]};
  const Principal trial = one_way_stress(principal(elastic), p);
  InPlane stress = in_axes(trial);
  const Lanes allowed = group.load(strength);
  LaneMask beyond =
      trial.first * trial.first + trial.second * trial.second - trial.first * trial.second >
      allowed * allowed;
  if (!surfaces.empty()) beyond |= group.load(surfaces.tensile_strength) > 0.0;
  if (!any(beyond, group.count())) return {stress, elastic};
  for (int l = 0; l < group.count(); ++l) {
    if (!beyond[l]) continue;
    const int point = group[l];
    PlaneTensor e{elastic.xx[l], elastic.yy[l], elastic.xy[l]};
    if (!has_surface(point)) flow(point, e, p);
    if (has_surface(point) && !integrity.failed(point)) {
      Frame frame;
      for (int i = 0; i < 3; ++i) frame.row(i) << local.x[i][l], local.y[i][l];
      open(point, e, frame, p);
      integrity.left[point] = 1 - surfaces.opened[point];
      if (integrity.failed(point)) integrity.fail(point);
    }
    const PlaneTensor s =
        integrity.failed(point) ? PlaneTensor{0, 0, 0} : in_axes(ElasticPoint(e, p).stress);
    elastic.xx[l] = e.xx, elastic.yy[l] = e.yy, elastic.xy[l] = e.xy;
    stress.xx[l] = s.xx, stress.yy[l] = s.yy, stress.xy[l] = s.xy;
  }
  return {stress, elastic};
}

void MembraneState<VonMises>::flow(int p, PlaneTensor& elastic, const MembraneProperties& m) {
  const ElasticPoint trial(elastic, m);
  const auto& s = trial.stress;
  const double softening_begins = std::max(internal[p], law.peak_strain());
  const auto localises = [&](const PlaneTensor& at, double increment) {
    const double at_most = law.strength(softening_begins);
    if (!law.decohesion || internal[p] + increment <= softening_begins || at_most == 0)
      return false;
    const double scale = at_most / equivalent_stress(at);
    return localise(p, {scale * at.xx, scale * at.yy, s.cos2, s.sin2}, m);
  };
  double increment;
  PlaneTensor plastic;
  if (trial.one_axis) {
    const OneAxisFlow direction(s.second / s.first);
    const double stiffness = trial.first_axis * direction.equivalent * direction.first;
    increment = return_along(law, s.first * direction.equivalent, internal[p], stiffness).increment;
    if (localises({s.first, s.second, 0}, increment)) increment = softening_begins - internal[p];
    plastic = from_axes({increment * direction.first, increment * direction.second, 0}, s);
  } else {
    const PlaneStressFlow path({s.first, s.second, 0}, m.moduli());
    double t = path.end(law, internal[p]);
    const double at_peak = law.decohesion ? path.at_increment(softening_begins - internal[p]) : t;
    if (localises(path.stress(at_peak), path.increment(t))) t = at_peak;
    increment = path.increment(t);
    plastic = from_axes(path.plastic_strain(t), s);
  }
  internal[p] += increment;
  strength[p] = law.strength(internal[p]);
  make_inelastic(p, plastic, elastic);
  dissipated[p] += trial.energy() - ElasticPoint(elastic, m).energy();
}

bool MembraneState<VonMises>::localise(int p, const PrincipalValues<double>& s,
                                       const MembraneProperties& m) {
  const auto analyse = law.decohesion->localization == Localization::plane_stress
                           ? plane_stress_bifurcation
                           : source_membrane_bifurcation;
  const Bifurcation found = analyse(s.first, s.second, m.moduli());
  if (!loses_ellipticity(-law.softening_modulus, found, m.moduli())) return false;
  const double c = std::cos(found.angle);
  const double n = std::sin(found.angle);
  surfaces.start(p, surface_at(*law.decohesion,
                               {s.first * c * c + s.second * n * n, (s.first - s.second) * c * n}));
  const double direction = 0.5 * std::atan2(s.sin2, s.cos2) + found.angle;
  surfaces.normal[0][p] = std::cos(direction);
  surfaces.normal[1][p] = std::sin(direction);
  return true;
}

void MembraneState<VonMises>::open(int p, PlaneTensor& elastic, const Frame& frame,
                                   const MembraneProperties& m) {
  const double before = ElasticPoint(elastic, m).energy();
  const Eigen::Vector2d normal(surfaces.normal[0][p], surfaces.normal[1][p]);
  const double length = effective_length(frame * normal, law.decohesion->cell);
  for (int i = 0; i < max_decohesion_updates; ++i) {
    if (!open_once(p, elastic, normal, length, m)) break;
  }
  const double after = surfaces.failed(p) ? 0 : ElasticPoint(elastic, m).energy();
  surfaces.dissipated[p] += length * (before - after);
}

bool MembraneState<VonMises>::open_once(int p, PlaneTensor& elastic, const Eigen::Vector2d& n,
                                        double length, const MembraneProperties& m) {
  const ElasticPoint trial(elastic, m);
  const Eigen::Vector2d t(-n.y(), n.x());
  const Eigen::Vector2d traction = times(in_axes(trial.stress), n);
  const double along_line = t.dot(traction);
  const auto [direction, effective] = decohesion_flow(*law.decohesion, surfaces.surface(p),
                                                      {n.dot(traction), std::abs(along_line)});
  const Eigen::Vector2d opening =
      direction.normal * n + std::copysign(direction.tangential, along_line) * t;
  const PlaneTensor strain{n.x() * opening.x() / length, n.y() * opening.y() / length,
                           0.5 * (n.x() * opening.y() + n.y() * opening.x()) / length};
  const PlaneTensor released =
      from_axes(trial.stress_change(to_axes(strain, trial.stress)), trial.stress);
  const double along_line_released = t.dot(times(released, n));
  const double at_axis =
      along_line * along_line_released > 0 ? along_line / along_line_released : HUGE_VAL;
  const double grown =
      decohesion_increment(*law.decohesion, surfaces.surface(p), surfaces.opened[p], effective,
                           length * contract(strain, released), at_axis);
  surfaces.opened[p] += grown;
  make_inelastic(p, grown * strain, elastic);
  return grown > 0 && !surfaces.failed(p);
}

void MembraneState<VonMises>::make_inelastic(int p, const PlaneTensor& strain,
                                             PlaneTensor& elastic) {
  elastic = elastic - strain;
  inelastic_strain[0][p] += strain.xx;
  inelastic_strain[1][p] += strain.yy;
  inelastic_strain[2][p] += strain.xy;
}

}  // namespace zona::mpm
