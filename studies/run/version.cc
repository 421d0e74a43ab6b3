#include "studies/run/version.h"

namespace zona::studies {

std::string zona_version() {
  return ZONA_VERSION;
}

std::string compiler_version() {
  return ZONA_COMPILER;
}

}  // namespace zona::studies
