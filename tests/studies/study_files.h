#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "studies/input/configuration.h"
#include "studies/kinds/study_kinds.h"
#include "tests/scratch_directory.h"

namespace zona::studies::testing {

using tests::ScratchDirectory;

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The problems of a study file in a directory, one per line, with names without that directory.
inline std::string problems_in(const ScratchDirectory& scratch, const std::string& file,
                               const std::vector<std::string>& overrides = {}) {
  try {
    load_configuration(scratch.path() / file, overrides);
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

/// The problems that a study text has, which is called "s.toml".
inline std::string problems_of(const std::string& text,
                               const std::vector<std::string>& overrides = {}) {
  const ScratchDirectory scratch;
  scratch.write("s.toml", text);
  return problems_in(scratch, "s.toml", overrides);
}

}  // namespace zona::studies::testing
