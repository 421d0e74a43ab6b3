#pragma once

#include <string>

#include "studies/input/configuration.h"

namespace zona::studies {

/// The study as a file with every key, defaults marked by a comment. It loads to the same values
/// from any directory: paths in it are absolute.
std::string resolved_study(const Configuration& study);

/// The first parameter that differs between two studies of whatever kind, for reading; empty if all
/// that decides the results is the same. The [run] table does not.
std::string first_difference(const Configuration& before, const Configuration& now);

/// Sixteen letters that all studies without such a difference share, and hardly any others.
std::string study_fingerprint(const Configuration& study);

/// Every parameter with its value in SI and where it comes from, one per line, for reading.
std::string si_table(const Configuration& study);

}  // namespace zona::studies
