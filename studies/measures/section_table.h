#pragma once

#include "studies/measures/averages.h"

namespace zona::studies {

/// A [[section]]: averages over the cells that a plane cuts.
struct SectionTable : Averages {
  int normal;    ///< axis that the plane stands across
  double place;  ///< where it cuts that axis [m]
};

/// The list [[section]]. Complains of what does not go together.
void declare_sections(Schema& schema, const MeasuredBodies& bodies);

}  // namespace zona::studies
