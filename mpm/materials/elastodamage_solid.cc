#include "mpm/materials/elastodamage_solid.h"

#include <Eigen/Eigenvalues>

namespace zona::mpm {

SolidState<Elastodamage>::SolidState(const Elastodamage& law, int points)
    : strain(points, 0.0), integrity(points, 1.0) {
  check(law);
  for (auto& component : effective_stress) component.assign(points, 0.0);
}

double largest_principal_strain(const SymmetricTensorLanes& s, int l, const ElasticModuli& moduli) {
  Eigen::Matrix3d stress;
  stress << s[0][l], s[3][l], s[5][l],  //
      s[3][l], s[1][l], s[4][l],        //
      s[5][l], s[4][l], s[2][l];
  const double largest = stress.selfadjointView<Eigen::Lower>().eigenvalues()[2];
  return ((1 + moduli.poisson_ratio) * largest - moduli.poisson_ratio * stress.trace()) /
         moduli.youngs_modulus;
}

void SolidState<Elastodamage>::damage_point(int p, double largest_strain, const Elastodamage& law) {
  if (largest_strain <= std::max(strain[p], law.elastic_limit)) return;
  strain[p] = largest_strain;
  integrity[p] = law.integrity(law.damage(largest_strain));
}

}  // namespace zona::mpm
