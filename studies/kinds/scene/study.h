#pragma once

#include "studies/run/study_kind.h"

namespace zona::studies {

/// `study = "scene"`: plain MPM, all of it in the file.
Job prepare_scene(const Configuration& study);
StudyCost estimate_scene(const Configuration& study);
std::string try_scene(const Configuration& study, int threads);

}  // namespace zona::studies
