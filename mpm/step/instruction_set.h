#pragma once

namespace zona::mpm {

/// Widest vector instructions of the loaded library: "AVX-512", "AVX2" or "SSE2".
const char* instruction_set();

}  // namespace zona::mpm
