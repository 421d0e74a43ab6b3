#pragma once

#include <vector>

#include "beam/system/beam_system.h"

/// Implementation of `zona::beam::assemble`, in a library of its own: loading deal.II takes half a
/// second and 100 MB, which only programs that assemble a beam should pay.
extern "C" void zona_beam_assemble(const zona::beam::Section& section,
                                   const zona::beam::BeamLayout& layout,
                                   zona::beam::BeamSystem& system);

/// Implementation of `zona::beam::quadrature_points`, in the same library.
extern "C" void zona_beam_quadrature_points(const zona::beam::Section& section,
                                            const zona::beam::BeamLayout& layout,
                                            std::vector<zona::beam::QuadraturePoint>& points);

namespace zona::beam {

/// Functions of the library of finite elements.
struct ElementsLibrary {
  decltype(&zona_beam_assemble) assemble;                    ///< zona_beam_assemble
  decltype(&zona_beam_quadrature_points) quadrature_points;  ///< zona_beam_quadrature_points
};

/// The library, loaded by the first call. Throws std::runtime_error if it cannot be loaded.
const ElementsLibrary& elements_library();

}  // namespace zona::beam
