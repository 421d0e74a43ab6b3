#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// [[probe]], [[profile]] and [[section]] of a scene, whose bodies are its [[body]].
void declare_scene_measures(Schema& schema);

}  // namespace zona::studies
