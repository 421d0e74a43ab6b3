#include "mpm/atomic_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace zona::mpm {

void replace_file(const std::string& path, std::string_view text) {
  const std::string unfinished = path + ".tmp";
  std::ofstream out(unfinished, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) {
    const std::string reason = std::strerror(errno);
    std::remove(unfinished.c_str());
    throw FileError(fmt::format("{}: cannot write the file ({})", unfinished, reason));
  }
  rename_over(unfinished, path);
}

void rename_over(const std::string& finished, const std::string& path) {
  if (std::rename(finished.c_str(), path.c_str()) == 0) return;
  const std::string reason = std::strerror(errno);
  std::remove(finished.c_str());
  throw FileError(fmt::format("{}: cannot replace the file ({})", path, reason));
}

}  // namespace zona::mpm
