#pragma once

#include <string>

#include "studies/run/run_directory.h"

namespace zona::studies {

/// Leaves word in the directory how far a run is, for `zona status`: the present line of progress.
void leave_status(const RunDirectory& directory, const std::string& line);
/// After the summary is written.
void remove_status(const RunDirectory& directory);

}  // namespace zona::studies
