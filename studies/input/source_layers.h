#pragma once

#include <vector>

#include "studies/input/study_source.h"

namespace zona::studies {

/// Adds the entries of a nearer layer, a file or an override, which replace those of farther
/// layers. Items may be given by name ("body.left.density"). A list of tables ([[body]]), even an
/// empty one, replaces the whole list. Setting a key twice at the same distance is a problem.
void amend(StudySource& source, std::vector<SourcedEntry> layer);

}  // namespace zona::studies
