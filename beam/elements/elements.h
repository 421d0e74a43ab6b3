#pragma once

#include <vector>

#include "beam/beam_system.h"

/// `zona::beam::assemble`, in a library of its own: deal.II brings two hundred libraries along,
/// half a second and 100 MB of them, which only those who assemble a beam shall pay for.
extern "C" void zona_beam_assemble(const zona::beam::Section& section,
                                   const zona::beam::BeamLayout& layout,
                                   zona::beam::BeamSystem& system);

/// `zona::beam::quadrature_points`.
extern "C" void zona_beam_quadrature_points(const zona::beam::Section& section,
                                            const zona::beam::BeamLayout& layout,
                                            std::vector<zona::beam::QuadraturePoint>& points);
