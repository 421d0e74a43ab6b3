#include "mpm/materials/elastodamage.h"

#include <fmt/format.h>

#include "mpm/points/errors.h"

namespace zona::mpm {

void check(const Elastodamage& m) {
  if (!(m.elastic_limit > 0)) {
    throw ModelError(fmt::format("the elastic limit must be positive, got {}", m.elastic_limit));
  }
  if (!(m.c0 >= 0) || !(m.c1 >= 0)) {
    throw ModelError(fmt::format("c_0 and c_1 must not be negative, got {} and {}", m.c0, m.c1));
  }
}

}  // namespace zona::mpm
