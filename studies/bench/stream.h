#pragma once

namespace zona::studies::bench {

/// Bytes per second of the STREAM triad, a = b + s c, with arrays of 128 MiB: 24 bytes an element,
/// the best of several sweeps. What the memory reads to own a line it writes is not counted.
double stream_triad(int threads);

}  // namespace zona::studies::bench
