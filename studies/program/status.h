#pragma once

#include <filesystem>
#include <string>

#include "studies/run/run_directory.h"

namespace zona::studies {

/// `zona status`: prints how far the run in a directory is, or how it ended. Throws InputError for
/// what is no run.
int show_status(const std::filesystem::path& directory);

/// Stores the present line of progress in the directory of a run, for `zona status`.
void leave_status(const RunDirectory& directory, const std::string& line);
/// Removes it, once the summary is written.
void remove_status(const RunDirectory& directory);

}  // namespace zona::studies
