#include "studies/run/memory.h"

#include <malloc.h>
#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <string>

namespace zona::studies {

long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

double available_memory() {
  std::ifstream stream("/proc/meminfo");
  for (std::string name, rest; stream >> name; std::getline(stream, rest)) {
    double kilobytes = 0;
    if (name == "MemAvailable:" && stream >> kilobytes) return 1024 * kilobytes;
  }
  return HUGE_VAL;
}

double allocated_memory() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

}  // namespace zona::studies
