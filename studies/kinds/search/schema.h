#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// The keys of a search study; lives as long as the program.
const Schema& search_schema();

}  // namespace zona::studies
