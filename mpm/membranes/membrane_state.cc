#include "mpm/membranes/membrane_state.h"

#include <limits>

namespace zona::mpm {

MembraneIntegrity::MembraneIntegrity(int points)
    : left(points, 1.0), failure_time(points, std::numeric_limits<double>::infinity()) {}

void MembraneIntegrity::fail(int p) {
  left[p] = 0;
  failure_time[p] = time;
#pragma omp critical(zona_membrane_failures)
  newly_failed.push_back(p);
}

MembraneState<IncrementalElastic>::MembraneState(const IncrementalElastic&, int points) {
  for (auto& component : previous_strain) component.assign(points, 0.0);
  for (auto& component : two_way_stress) component.assign(points, 0.0);
}

MembraneResponse MembraneState<IncrementalElastic>::respond(const PointGroup& group,
                                                            const LocalStrain& local,
                                                            const Principal&,
                                                            const MembraneProperties& p,
                                                            MembraneIntegrity&) {
  const double nu = p.poisson_ratio;
  const double modulus = p.moduli().plane_stress();
  const auto old_strain = group.load(previous_strain);
  const auto old_stress = group.load(two_way_stress);
  const InPlane step = local.strain - InPlane{old_strain[0], old_strain[1], old_strain[2]};
  const InPlane s{old_stress[0] + modulus * (step.xx + nu * step.yy),
                  old_stress[1] + modulus * (step.yy + nu * step.xx),
                  old_stress[2] + modulus * (1 - nu) * step.xy};
  group.store(previous_strain, {local.strain.xx, local.strain.yy, local.strain.xy});
  group.store(two_way_stress, {s.xx, s.yy, s.xy});
  const double compliance = 1 / p.youngs_modulus;
  const InPlane strain{compliance * (s.xx - nu * s.yy), compliance * (s.yy - nu * s.xx),
                       compliance * (1 + nu) * s.xy};
  return {membrane_stress(principal(strain), p), strain};
}

MembraneState<Elastodamage>::MembraneState(const Elastodamage& l, int points)
    : law(l), damage(points, 0.0) {
  check(l);
}

MembraneResponse MembraneState<Elastodamage>::respond(const PointGroup& group,
                                                      const LocalStrain& local, const Principal& e,
                                                      const MembraneProperties& p,
                                                      MembraneIntegrity& integrity) {
  grow_damage(group, e.first, integrity);
  return {group.load(integrity.left) * membrane_stress(e, p), local.strain};
}

void MembraneState<Elastodamage>::grow_damage(const PointGroup& group, const Lanes& strain,
                                              MembraneIntegrity& integrity) {
  const Lanes limit = law.elastic_limit * (1.0 + group.load(damage));
  if (!any(strain > limit, group.count())) return;
  for (int l = 0; l < group.count(); ++l) {
    const int p = group[l];
    if (integrity.failed(p) || !(strain[l] > limit[l])) continue;
    damage[p] = law.damage(strain[l]);
    integrity.left[p] = law.integrity(damage[p]);
    if (integrity.failed(p)) integrity.fail(p);
  }
}

}  // namespace zona::mpm
