#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/input/toml_document.h"

namespace zona::studies {

/// The value of one key, checked against its declaration.
struct Setting {
  TomlValue written;               ///< as the user (or the default) has it
  std::vector<double> numbers;     ///< one per item; quantities in SI
  std::vector<std::string> texts;  ///< one per item, as written: "mercury", "13.5 um"
  bool is_auto = false;
  bool is_default = false;
  std::string where;                ///< "file:line" or "--set"; empty for a default
  int line = 0;                     ///< 0 for defaults and overrides
  std::filesystem::path directory;  ///< where relative paths start; empty: at the study file
  bool is_inherited = false;        ///< given in a file that the study is based on
};

}  // namespace zona::studies
