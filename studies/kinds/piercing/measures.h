#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// [[probe]], [[profile]] and [[section]] of a piercing, whose bodies have fixed names and whose
/// places count from the middle of the egg.
void declare_piercing_measures(Schema& schema);

}  // namespace zona::studies
