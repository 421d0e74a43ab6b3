#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// The keys of a comparison study; lives as long as the program.
const Schema& comparison_schema();

}  // namespace zona::studies
