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
  /// 0 for an override, 1 for the study file, 2 for its base, ...
  int layer = 0;
  std::filesystem::path
      directory;        ///< where relative paths in the value start; empty: as a study's
  bool amends = false;  ///< whether it changes a farther layer

  bool is_inherited() const { return layer > 1; }
};

/// The input of the user, before the study kind is known.
struct StudySource {
  std::vector<SourcedEntry> entries;  ///< nearer layers replace entries of farther ones
  std::vector<Problem> problems;      ///< of the overrides and of `base`
};

/// Reads the file, the files that it is based on (`base = "..."`), and the overrides
/// (`key=TOML-value`). Throws InputError when a file cannot be read or is not TOML.
StudySource read_study_source(const std::filesystem::path& file,
                              const std::vector<std::string>& overrides);

}  // namespace zona::studies
