#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "studies/piercing_case.h"
#include "studies/session.h"
#include "studies/solver_march.h"
#include "studies/study_kinds.h"

namespace zona::studies {

/// Runs one piercing and writes history.csv, fields.h5, fields.xdmf and, for a tip history, tip.csv
/// into an existing directory. `results` becomes its entry of summary.json; when interrupted, of
/// what was computed, and so too when a point goes wrong (mpm::PointError passes through).
void run_piercing(const PiercingCase& piercing, const OutputPlan& plan,
                  const std::filesystem::path& directory, const std::string& label,
                  Session& session, nlohmann::json& results);

/// Points and steps of a piercing, in a line.
StudyCost piercing_cost(const PiercingCase& piercing);

}  // namespace zona::studies
