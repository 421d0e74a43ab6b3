#pragma once

#include <nlohmann/json.hpp>

#include "studies/kinds/scene/case.h"
#include "studies/run/session.h"
#include "studies/simulation/solver_march.h"

namespace zona::studies {

/// Runs a scene, whose model it takes, and writes history.csv, profiles.csv, fields.h5 and
/// fields.xdmf into the run directory. The session's results are of what was computed also when it
/// was interrupted or a point went wrong (mpm::PointError passes through).
void run_scene(SceneCase& scene, Session& session);

}  // namespace zona::studies
