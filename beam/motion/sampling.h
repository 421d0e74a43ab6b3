#pragma once

namespace zona::beam {

/// Samples at 0, step, 2 step, ... up to the first that reaches the end.
struct Sampling {
  double end = 5e-3;     ///< [s]
  double step = 0.6e-6;  ///< [s]
};

/// Number of samples, including t = 0. Throws std::invalid_argument for a step or an end that is
/// not positive, and for more than 1e8 samples.
int sample_count(const Sampling& sampling);

}  // namespace zona::beam
