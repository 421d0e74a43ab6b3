#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// The keys of a piercing study; lives as long as the program.
const Schema& piercing_schema();

}  // namespace zona::studies
