#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "studies/kinds/vibration/result.h"
#include "studies/run/run_directory.h"

namespace zona::studies {

/// An entry of the results.
nlohmann::json to_json(const VibrationResult& result);

/// history.csv: time and one column of tip displacement per case, then those along the pipette.
void write_history(const RunDirectory& directory, const std::vector<VibrationResult>& results);

/// amplitudes.csv: one row per case.
void write_amplitudes(const RunDirectory& directory, const std::vector<VibrationResult>& results);

/// sensitivities.csv: one row per case and input; elasticities are relative changes per relative
/// change of the input.
void write_sensitivities(const RunDirectory& directory,
                         const std::vector<VibrationResult>& results);

}  // namespace zona::studies
