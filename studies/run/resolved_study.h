#pragma once

#include <string>

#include "studies/input/configuration.h"

namespace zona::studies {

/// The study as a file with every key, defaults marked by a comment. It loads to the same values
/// from any directory: paths in it are absolute.
std::string resolved_study(const Configuration& study);

/// A text that names the first parameter that differs between two studies of any kind. Empty when
/// they give the same results; the [run] table does not count.
std::string first_difference(const Configuration& before, const Configuration& now);

/// A hash in sixteen hexadecimal digits, equal for studies without such a difference.
std::string study_fingerprint(const Configuration& study);

/// A text for people: every parameter with its value in SI and its origin, one per line.
std::string si_table(const Configuration& study);

}  // namespace zona::studies
