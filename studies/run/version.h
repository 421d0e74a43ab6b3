#pragma once

#include <string>

namespace zona::studies {

/// Version of the program, e.g. "0.1.0".
std::string zona_version();

/// The compiler that built it, e.g. "GCC 12.2.0".
std::string compiler_version();

}  // namespace zona::studies
