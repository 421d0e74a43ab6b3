#pragma once

#include "studies/run/study_kind.h"

namespace zona::studies {

/// `study = "piercing"`: one fill, one motion.
Job prepare_piercing(const Configuration& study);
StudyCost estimate_piercing(const Configuration& study);
std::string try_piercing(const Configuration& study, int threads);

/// `study = "comparison"`: one pulse, several fills; beam, coupling and piercing for each, then a
/// table.
Job prepare_comparison(const Configuration& study);
StudyCost estimate_comparison(const Configuration& study);
std::string try_comparison(const Configuration& study, int threads);

}  // namespace zona::studies
