#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/run/study_kind.h"

namespace zona::studies {

/// All study kinds, in the order in which they are listed.
const std::vector<StudyKind>& study_kinds();

/// Throws std::logic_error for a kind that does not exist.
const StudyKind& find_study_kind(const std::string& name);

/// The configuration of a study of any kind (load_configuration with all schemas). Throws
/// InputError.
Configuration load_configuration(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides = {});

}  // namespace zona::studies
