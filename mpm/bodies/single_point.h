#pragma once

#include "mpm/bodies/body.h"

namespace zona::mpm {

/// How a solid in three dimensions carries stress and fails.
using SolidLaw = std::variant<Elastic, VonMises, Elastodamage>;

/// A symmetric tensor, components xx yy zz xy yz zx (tensor components also of shear strain).
using SymmetricTensor = std::array<double, 6>;

/// a : b
double contract(const SymmetricTensor& a, const SymmetricTensor& b);
/// sqrt(3 J2) of a stress.
double equivalent_stress(const SymmetricTensor& stress);

/// What is known of a point.
struct PointSample {
  SymmetricTensor strain{};     ///< that it was given [-]
  SymmetricTensor stress{};     ///< Cauchy [Pa]
  double stored_energy = 0;     ///< elastic [J/m^3]
  double internal = 0;          ///< I_s of von Mises plasticity (5.15) [-]
  double left = 1;              ///< stiffness under damage, or 1 - lambda^d; 0 = failed [-]
  double flow_dissipation = 0;  ///< by plastic flow [J/m^3]
  DecohesionSurface surface{};  ///< of decohesion
  /// Of the surface, in the frame of the strain: unit vector, or zero where there is none.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double opening_dissipation = 0;  ///< [J/m^2]
  double resolved_energy = 0;      ///< what a resolved opening of the surface dissipates [J/m^2]
  double effective_length = 0;     ///< L_e of the surface [m]
};

/// One point of a solid, or of a membrane that stays flat, outside of any grid: a law driven by
/// strains alone. It can be copied, tried and thrown away.
class SinglePoint {
 public:
  /// Throws ModelError.
  SinglePoint(const ElasticModuli& moduli, const SolidLaw& law);
  /// Plane stress in x and y, with objective kinematics: strains are stretches less one.
  SinglePoint(const MembraneProperties& properties, const MembraneLaw& law);

  /// One step to a total strain. A membrane takes xx, yy and xy and ignores the rest.
  void strain_to(const SymmetricTensor& strain);
  PointSample sample() const;     ///< its present state
  double youngs_modulus() const;  ///< [Pa]

 private:
  struct Sheet {
    MaterialPoints points;
    Membrane membrane;
  };
  using Point = std::variant<Solid<Elastic>, Solid<VonMises>, Solid<Elastodamage>, Sheet>;

  static Point solid_point(const ElasticModuli& moduli, const SolidLaw& law);
  static Point sheet_point(const MembraneProperties& properties, const MembraneLaw& law);

  Point point_;
  SymmetricTensor strain_{};
};

}  // namespace zona::mpm
