#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// Checks of the geometry across the tables of a piercing, which must be declared.
void check_piercing_geometry(Schema& schema);

}  // namespace zona::studies
