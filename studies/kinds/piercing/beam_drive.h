#pragma once

#include "studies/input/schema.h"

namespace zona::studies {

/// The sections [beam], [bath] and [pulse] and the list [[column]], used where a beam drives the
/// tip.
void declare_beam_drive(Schema& schema);

}  // namespace zona::studies
