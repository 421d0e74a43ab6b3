#pragma once

#include "studies/kinds/scene/case.h"
#include "studies/run/session.h"

namespace zona::studies {

/// Runs a scene, whose model it takes, and writes history.csv, profiles.csv, sections.csv,
/// fields.h5 and fields.xdmf into the run directory. The session's results are set also when the
/// run was interrupted or a step failed (mpm::StepError passes through): they then cover what was
/// computed.
void run_scene(SceneCase& scene, Session& session);

}  // namespace zona::studies
