#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/input_error.h"
#include "studies/toml_document.h"

namespace zona::studies {

/// An entry of a study and where it was given.
struct SourcedEntry {
  TomlEntry entry;
  std::string where;  ///< "file:line" or "--set"
  int line = 0;       ///< 0 for an override
};

/// What the user wrote, before anything is known about the study kind.
struct StudySource {
  std::vector<SourcedEntry> entries;  ///< overrides replace entries of the file
  std::vector<Problem> problems;      ///< of the overrides
};

/// Reads the file and the overrides (`key=TOML-value`). Throws InputError when the file cannot be
/// read or is not TOML.
StudySource read_study_source(const std::filesystem::path& file,
                              const std::vector<std::string>& overrides);

}  // namespace zona::studies
