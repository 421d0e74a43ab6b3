#include "mpm/points/errors.h"

#include <fmt/format.h>

namespace zona::mpm {

PointError::PointError(const std::string& what_happened, const std::string& body, int point,
                       const Eigen::Vector3d& position, long step, double time)
    : StepError(fmt::format(
          "{}: point {} of body '{}' at ({:.6g}, {:.6g}, {:.6g}) m in step {}, time {:.6g} s",
          what_happened, point, body, position.x(), position.y(), position.z(), step, time)) {}

}  // namespace zona::mpm
