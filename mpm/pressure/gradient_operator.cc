#include "mpm/pressure/gradient_operator.h"

namespace zona::mpm {

GradientOperator::GradientOperator(const CellLattice& lattice)
    : row_(lattice.row), layer_(lattice.layer) {
  corner_.fill(FloatField(lattice.size, 0.0f));
}

void GradientOperator::set(long place, const FluidSums& sums,
                           const std::array<double, 3>& inverse) {
  for (int axis = 0; axis < 3; ++axis) {
    // Sums with one of the two coordinates across the axis, and with both.
    const double first = sums.moment[axis == 0 ? 1 : 0];
    const double second = sums.moment[axis == 2 ? 1 : 2];
    const double both = sums.moment[3 + (axis + 1) % 3];
    const double value[4] = {sums.volume - first - second + both, first - both, second - both,
                             both};
    for (int n = 0; n < 4; ++n)
      corner_[4 * axis + n][place] = static_cast<float>(value[n] * inverse[axis]);
  }
}

void GradientOperator::add_diagonal(const std::array<FloatField, 3>& mobility, const Chunk& chunk,
                                    float* diagonal) const {
  for (int axis = 0; axis < 3; ++axis) {
    const Steps s = steps(axis);
    for (int corner = 0; corner < 4; ++corner) {
      const float* g = corner_[4 * axis + corner].data();
      const float* near = mobility[axis].data() + s.to(corner);
      const float* far = near + s.along;
#pragma omp simd
      for (long c = chunk.begin; c < chunk.end; ++c)
        diagonal[c] += g[c] * g[c] * (near[c] + far[c]);
    }
  }
}

}  // namespace zona::mpm
