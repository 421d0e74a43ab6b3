#pragma once

#include <nlohmann/json.hpp>

#include "studies/kinds/piercing/case.h"
#include "studies/run/study_kind.h"
#include "studies/simulation/simulation.h"

namespace zona::studies {

/// Runs one piercing and writes history.csv, fields.h5, fields.xdmf and, for a tip history,
/// tip.csv. `results` becomes its entry of summary.json, also when the run was interrupted or a
/// step failed (mpm::StepError passes through): it then covers what was computed.
void run_piercing(const PiercingCase& piercing, const SimulationContext& context,
                  nlohmann::json& results);

/// Points and steps of a piercing, in a line.
StudyCost piercing_cost(const PiercingCase& piercing);

}  // namespace zona::studies
