#include "studies/run/provenance.h"

#include <fmt/format.h>
#include <zona_commit.h>

#include <fstream>

#include "mpm/step/instruction_set.h"
#include "studies/run/version.h"

namespace zona::studies {

std::string commit() {
  return ZONA_COMMIT;
}

bool is_modified() {
  return ZONA_COMMIT_IS_MODIFIED;
}

std::string processor_name() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t value = line.find(": ");
    if (line.rfind("model name", 0) == 0 && value != std::string::npos)
      return line.substr(value + 2);
  }
  return "unknown";
}

std::string provenance() {
  return fmt::format("zona {} (commit {}{}, {}, {} on {})", zona_version(), commit(),
                     is_modified() ? " with changes" : "", compiler_version(),
                     mpm::instruction_set(), processor_name());
}

}  // namespace zona::studies
