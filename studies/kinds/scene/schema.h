#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// The keys of a scene study; lives as long as the program.
const Schema& scene_schema();

}  // namespace zona::studies
