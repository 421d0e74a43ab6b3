#pragma once

#include "studies/input/configuration.h"
#include "studies/run/study_kind.h"

namespace zona::studies {

/// Checks the model; the job writes history.csv and the results.
Job prepare_material_point(const Configuration& study);

/// The size of the study.
StudyCost estimate_material_point(const Configuration& study);

}  // namespace zona::studies
