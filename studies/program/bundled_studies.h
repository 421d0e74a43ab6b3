#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace zona::studies {

/// A study file that comes with the program.
struct BundledStudy {
  std::filesystem::path file;
  std::string description;  ///< its first comment line
};

/// Folders of the bundled studies, and of the scripts of reports and figures: those installed next
/// to the program, else those of its source.
std::filesystem::path study_directory();
std::filesystem::path report_directory();

/// The bundled study files and those in verification/, by name: those installed next to the
/// program, else those of its source.
std::vector<BundledStudy> bundled_studies();

}  // namespace zona::studies
