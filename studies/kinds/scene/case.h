#pragma once

#include <string>

#include "mpm/step/solver.h"
#include "studies/input/configuration.h"
#include "studies/parameters/time_step.h"
#include "studies/run/study_kind.h"

namespace zona::studies {

/// A scene, ready to run; all its input is checked.
struct SceneCase {
  Configuration study;
  mpm::Model model;  ///< bodies in the order of the file
  TimeStep step;
  double end;  ///< [s]
};

/// Throws InputError, naming file and line.
SceneCase make_scene_case(const Configuration& study);

/// Cells, points and mass of each body, and steps, in a few lines.
StudyCost scene_cost(const SceneCase& scene);

}  // namespace zona::studies
