#pragma once

#include <vector>

#include "studies/input/study_source.h"

namespace zona::studies {

/// Puts the entries of a nearer layer, a file or one override, over those that are there. Keys of
/// items may have their names ("body.left.density"). A list of tables ([[body]]) replaces the one
/// that is there, also by an empty one. A key that an equally near layer has set already is a
/// problem.
void amend(StudySource& source, std::vector<SourcedEntry> layer);

}  // namespace zona::studies
