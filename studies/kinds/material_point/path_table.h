#pragma once

#include <vector>

#include "mpm/bodies/mixed_control.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// Words for the components of mpm::SymmetricTensor, in its order.
inline const Words<int> kStrainComponents{{"xx", 0}, {"yy", 1}, {"zz", 2},
                                          {"xy", 3}, {"yz", 4}, {"zx", 5}};

/// Components in the plane of a membrane.
inline const std::vector<int> kPlaneComponents{0, 1, 3};

/// Strain path of a point: strains at the ends of its segments; a shorter list stays at its last
/// value.
struct StrainPath {
  std::vector<double> xx, yy, zz, xy, yz, zx;
  std::vector<int> free;  ///< components with free strain
  long steps;             ///< of each segment

  mpm::FreeComponents free_components() const;
  /// Strains at the ends of the segments; zero for free components.
  std::vector<mpm::SymmetricTensor> targets() const;
};

/// The section [path], after [material]. Checks that the choices are compatible.
void declare_path(Schema& schema);

}  // namespace zona::studies
