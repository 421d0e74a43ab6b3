#include "mpm/materials/prescribed.h"

#include <utility>

namespace zona::mpm {

Prescribed::Prescribed(const MaterialPoints& points, double density_, RigidMotion motion_,
                       Drive drive_)
    : density(density_),
      motion(std::move(motion_)),
      drive(drive_),
      initial_position(points.position) {}

}  // namespace zona::mpm
