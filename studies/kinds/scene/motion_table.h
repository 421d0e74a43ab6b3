#pragma once

#include <vector>

#include "mpm/materials/prescribed.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// Motion of a [[body]], by components x, y, z.
struct BodyMotion {
  std::vector<Formula> velocity;      ///< initial, of the place [m/s]; none of a rigid body
  std::vector<Formula> displacement;  ///< of a rigid body, of time [m]; none of others
  mpm::Drive drive;                   ///< of a rigid body
};

/// Keys of the motion in a section that is open, under the conditions of a body that deforms and
/// of one that is rigid.
void declare_body_motion(Schema& schema, const std::string& section, const Condition& deforms,
                         const Condition& is_rigid);

}  // namespace zona::studies
