#pragma once

namespace zona::mpm {

/// The widest vector instructions that this build of the library uses: "AVX-512", "AVX2" or "SSE2".
const char* instruction_set();

}  // namespace zona::mpm
