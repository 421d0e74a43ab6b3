#pragma once

#include <vector>

namespace zona::coupling {

/// Derivatives of samples at increasing, not necessarily equidistant times: the slope at each
/// sample of the parabola through it and its neighbours (at the ends, through the three outermost
/// samples). Second order; exact for parabolas. Throws std::invalid_argument for fewer than three
/// samples or another number of times.
std::vector<double> second_order_slopes(const std::vector<double>& time,
                                        const std::vector<double>& values);

}  // namespace zona::coupling
