#pragma once

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <string>

#include "studies/configuration.h"

namespace zona::studies::testing {

/// A directory that lives as long as the object.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "zona_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch directory");
    path_ = name;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The problems that a study text has, one per line, with file names reduced to "s.toml".
inline std::string problems_of(const std::string& text,
                               const std::vector<std::string>& overrides = {}) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.write("s.toml", text);
  try {
    load_configuration(file, overrides);
    return "";
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::string prefix = scratch.path().string() + "/";
    for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
      message.erase(at, prefix.size());
    }
    return message;
  }
}

}  // namespace zona::studies::testing
