#include "beam/pipette/section.h"

#include <cmath>

namespace zona::beam {

double UniformBeam::dispersion() const {
  return std::sqrt(flexural_rigidity / mass_per_length);
}

Section section_of(const UniformBeam& beam) {
  return {beam.length, [beam](double) { return beam.flexural_rigidity; },
          [beam](double) { return beam.mass_per_length; }};
}

}  // namespace zona::beam
