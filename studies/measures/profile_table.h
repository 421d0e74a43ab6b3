#pragma once

#include <optional>

#include "studies/measures/averages.h"
#include "studies/measures/membership.h"
#include "studies/parameters/box.h"

namespace zona::studies {

/// A [[profile]]: averages over slices of a box.
struct ProfileTable : BoxKeys, Averages {
  int axis;                     ///< that the slices stand across
  std::optional<double> width;  ///< of a slice [m]; empty: `cells` cells
  int cells;
  Membership membership;
};

/// The list [[profile]]. Complains of what does not go together.
void declare_profiles(Schema& schema, const MeasuredBodies& bodies);

}  // namespace zona::studies
