#include "mpm/files/read_file.h"

#include <array>
#include <fstream>

namespace zona::mpm {

std::optional<std::string> read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string content;
  std::array<char, 1 << 14> part;
  while (stream) {
    stream.read(part.data(), part.size());
    content.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad()) return std::nullopt;
  return content;
}

}  // namespace zona::mpm
