#pragma once

#include "studies/input/table_keys.h"

namespace zona::studies {

struct Gravity {
  Eigen::Vector3d acceleration{0, 0, 0};  ///< [m/s^2]
};

/// The section [gravity].
void declare_gravity(Schema& schema);

}  // namespace zona::studies
