#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// The keys of a material_point study; lives as long as the program.
const Schema& material_point_schema();

}  // namespace zona::studies
