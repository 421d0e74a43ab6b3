#pragma once

#include <vector>

#include "beam/system/beam_system.h"

/// `zona::beam::assemble`. It lies in a library of its own, because loading deal.II takes half a
/// second and 100 MB, which only programs that assemble a beam should pay for.
extern "C" void zona_beam_assemble(const zona::beam::Section& section,
                                   const zona::beam::BeamLayout& layout,
                                   zona::beam::BeamSystem& system);

/// `zona::beam::quadrature_points`, in the same library.
extern "C" void zona_beam_quadrature_points(const zona::beam::Section& section,
                                            const zona::beam::BeamLayout& layout,
                                            std::vector<zona::beam::QuadraturePoint>& points);

namespace zona::beam {

/// Functions of the library of finite elements.
struct ElementsLibrary {
  decltype(&zona_beam_assemble) assemble;                    ///< mass and stiffness of all elements
  decltype(&zona_beam_quadrature_points) quadrature_points;  ///< where they are integrated
};

/// The library, loaded with the first call. Throws std::runtime_error if it cannot be loaded.
const ElementsLibrary& elements_library();

}  // namespace zona::beam
