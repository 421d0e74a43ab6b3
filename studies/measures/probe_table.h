#pragma once

#include <string>
#include <vector>

#include "studies/measures/measured_bodies.h"
#include "studies/measures/membership.h"
#include "studies/measures/point_values.h"
#include "studies/parameters/box.h"

namespace zona::studies {

enum class ProbeKind { point, mean };

/// A [[probe]]: the point nearest to a place, or the mean over the points in a box.
struct ProbeTable : BoxKeys {
  std::string body;
  ProbeKind kind;
  Eigen::Vector3d place{0, 0, 0};                ///< of a point [m]
  Membership membership = Membership::initial;   ///< of a mean
  std::vector<const PointQuantity*> quantities;  ///< that are followed
};

/// The list [[probe]]. Complains of quantities that a body does not have.
void declare_probes(Schema& schema, const MeasuredBodies& bodies);

}  // namespace zona::studies
