#pragma once

#include "mpm/bodies/single_point.h"
#include "studies/input/configuration.h"
#include "studies/run/study_kind.h"

namespace zona::studies {

/// The point that the study describes, at rest. Throws mpm::ModelError.
mpm::SinglePoint material_point(const Configuration& study);

/// Finds what the model refuses; the job writes history.csv and the results.
Job prepare_material_point(const Configuration& study);

/// The size of the study.
StudyCost estimate_material_point(const Configuration& study);

}  // namespace zona::studies
