#pragma once

#include <filesystem>

namespace zona::studies {

/// `zona report`: writes report.html and the folder report into the directory of a run, and prints
/// where. Throws InputError if it is not the directory of a run, RunError when Python fails.
int write_report(const std::filesystem::path& directory);

}  // namespace zona::studies
