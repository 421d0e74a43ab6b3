#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/input/input_error.h"
#include "studies/input/toml_document.h"

namespace zona::studies {

/// An entry of a study and where it was given.
struct SourcedEntry {
  TomlEntry entry;
  std::string where;  ///< "file:line" or "--set"
  int line = 0;       ///< 0 for an override
  /// How far from the user's last word: 0 an override, 1 the study file, 2 its base, ...
  int layer = 0;
  std::filesystem::path
      directory;        ///< where relative paths in the value start; empty: as a study's
  bool amends = false;  ///< whether it stands above another layer

  bool is_inherited() const { return layer > 1; }
};

/// What the user wrote, before anything is known about the study kind.
struct StudySource {
  std::vector<SourcedEntry> entries;  ///< nearer layers replace entries of farther ones
  std::vector<Problem> problems;      ///< of the overrides and of `base`
};

/// Reads the file, the files that it is based on (`base = "..."`), and the overrides
/// (`key=TOML-value`). Throws InputError when a file cannot be read or is not TOML.
StudySource read_study_source(const std::filesystem::path& file,
                              const std::vector<std::string>& overrides);

}  // namespace zona::studies
