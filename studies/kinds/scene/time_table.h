#pragma once

#include "studies/input/table_keys.h"

namespace zona::studies {

/// Duration of a scene; its step is StepChoice.
struct SceneTime {
  double end;  ///< [s]
};

/// The section [time]. Complains of a step that does not fit the run.
void declare_scene_time(Schema& schema);

}  // namespace zona::studies
