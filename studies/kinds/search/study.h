#pragma once

#include "studies/run/study_kind.h"

namespace zona::studies {

/// `study = "search"`: designs by the thousand by their beams, the best by their piercings, with
/// uncertain inputs; then a ranked table.
Job prepare_search(const Configuration& study);
StudyCost estimate_search(const Configuration& study);
std::string try_search(const Configuration& study, int threads);

}  // namespace zona::studies
