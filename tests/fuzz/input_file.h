#pragma once

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

#include "tests/scratch_directory.h"

namespace zona::tests {

/// A file whose content changes from one input to the next; `folder` is removed at the end.
class InputFile {
 public:
  explicit InputFile(const std::string& name) : path_(folder / name) {}

  const std::string& path() const { return path_; }
  void write(std::string_view bytes) const {
    std::ofstream stream(path_, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  const ScratchDirectory folder;

 private:
  std::string path_;
};

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the fuzzer with a finding that no sanitizer would notice.
[[noreturn]] inline void broken(const std::string& promise) {
  std::cerr << "broken promise: " << promise << std::endl;
  std::abort();
}

}  // namespace zona::tests
