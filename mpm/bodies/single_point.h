#pragma once

#include "mpm/bodies/body.h"

namespace zona::mpm {

/// Material laws of a solid in three dimensions.
using SolidLaw = std::variant<Elastic, VonMises, Elastodamage>;

/// A symmetric tensor, components xx yy zz xy yz zx (shear strains are the tensor's, half of the
/// engineering ones).
using SymmetricTensor = std::array<double, 6>;

/// a : b
double contract(const SymmetricTensor& a, const SymmetricTensor& b);
/// sqrt(3 J2) of a stress [Pa].
double equivalent_stress(const SymmetricTensor& stress);

/// State of a point.
struct PointSample {
  SymmetricTensor strain{};     ///< total, as prescribed [-]
  SymmetricTensor stress{};     ///< Cauchy [Pa]
  double stored_energy = 0;     ///< elastic [J/m^3]
  double internal = 0;          ///< I_s of von Mises plasticity (5.15) [-]
  double left = 1;              ///< 1 - damage, or 1 - lambda^d; 0 = failed [-]
  double flow_dissipation = 0;  ///< energy dissipated by plastic flow [J/m^3]
  DecohesionSurface surface{};  ///< surface of decohesion, if present
  /// Unit normal of the surface in the frame of the strain; zero without a surface.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double opening_dissipation = 0;  ///< energy dissipated by opening [J/m^2]
  double resolved_energy = 0;      ///< energy of a resolved opening of the surface [J/m^2]
  double effective_length = 0;     ///< L_e of the surface [m]
};

/// One point of a solid, or of a flat membrane, without a grid: a law driven by strains. Copies are
/// independent, so a strain can be tried on a copy.
class SinglePoint {
 public:
  /// A point of a solid. Throws ModelError.
  SinglePoint(const ElasticModuli& moduli, const SolidLaw& law);
  /// A point of a membrane: plane stress in x and y, with objective kinematics; strains are
  /// stretches minus one. Throws ModelError.
  SinglePoint(const MembraneProperties& properties, const MembraneLaw& law);

  /// Takes one step to a total strain. A membrane uses xx, yy and xy and ignores the rest.
  void strain_to(const SymmetricTensor& strain);
  PointSample sample() const;     ///< current state
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
