#pragma once

#include <vector>

#include "studies/input/configuration.h"
#include "studies/kinds/vibration/result.h"
#include "studies/run/study_kind.h"

namespace zona::studies {

/// Computes all cases in parallel; the results are in the order of the cases and do not depend on
/// the number of threads. After an interrupt the cases not begun are left out.
std::vector<VibrationResult> compute_vibration(const Configuration& study, Session& session);

/// Checks the pipettes; the job writes amplitudes.csv (a row per case), history.csv (time and one
/// column of tip displacement per case) if wanted, the results and the table.
Job prepare_vibration(const Configuration& study);

/// The size of the study in one line.
StudyCost estimate_vibration(const Configuration& study);

/// Time that the cases will take here, from trying the first one.
std::string try_vibration(const Configuration& study, int threads);

}  // namespace zona::studies
