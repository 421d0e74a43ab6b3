#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// The keys of a vibration study; lives as long as the program.
const Schema& vibration_schema();

}  // namespace zona::studies
