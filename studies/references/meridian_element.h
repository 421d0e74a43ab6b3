#pragma once

#include <Eigen/Core>

#include "studies/references/membrane_law.h"

namespace zona::studies::references {

/// A conical element of a membrane of revolution: r1, z1, r2, z2 [m].
using MeridianElement = Eigen::Vector4d;

/// A value with its derivatives with respect to r1, z1, r2, z2.
struct ElementQuantity {
  double value;
  Eigen::Vector4d gradient;
  Eigen::Matrix4d second;
};

/// Volume between the element and the axis, pi (z2 - z1)(r1^2 + r1 r2 + r2^2)/3 [m^3].
ElementQuantity element_volume(const MeridianElement& x);

/// Length over the undeformed one.
ElementQuantity meridional_stretch(const MeridianElement& x, double undeformed);

/// Strains along the meridian and around the axis, with their derivatives.
struct ElementStrain {
  double along, around;
  Eigen::Vector4d along_gradient, around_gradient;
};

/// The law's measure of the stretches l/L and (r1 + r2)/(R1 + R2).
ElementStrain strain_of_stretches(StrainMeasure measure, const MeridianElement& reference,
                                  const MeridianElement& now);

/// Strain rr, zz, rz and hoop of an element that has moved from `last` to `now`, added to `sum`, as
/// in (4.4): fixed axes, midpoint rule.
Eigen::Vector4d summed_strain(const Eigen::Vector4d& sum, const MeridianElement& last,
                              const MeridianElement& now);

/// Summed strain in the axes of the element (4.10), when `sum` is the strain at `last` and the
/// element is at `now`.
ElementStrain strain_of_sum(const Eigen::Vector4d& sum, const MeridianElement& last,
                            const MeridianElement& now);

/// Forces [N] with which the element resists, and their derivatives [N/m].
struct ElementForces {
  Eigen::Vector4d force;
  Eigen::Matrix4d stiffness;
};

/// From the tensions of the law at the strains. `unwrinkled_share` of the law without wrinkles is
/// mixed into wrinkled and slack states.
ElementForces element_forces(const MembraneLaw& law, double unwrinkled_share,
                             const MeridianElement& reference, const MeridianElement& now,
                             const ElementStrain& strain);

}  // namespace zona::studies::references
