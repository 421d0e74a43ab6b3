#pragma once

#include "mpm/bodies/body.h"
#include "studies/kinds/scene/shape.h"

namespace zona::studies {

/// The body that a [[body]] table describes, in its initial state. `cut` is true at places that
/// other bodies take. Throws InputError, naming key and line.
mpm::Body scene_body(const Table& table, const mpm::BackgroundGrid& grid, const Inside& inside,
                     const Inside& cut);

}  // namespace zona::studies
