#pragma once

#include <string>

#include "studies/kinds/search/record.h"

namespace zona::studies::search {

/// The finalists as a table for people, the best first, after the reference; then a summary and the
/// uncertain inputs that make a design violate its limits. Needs verdicts.
std::string ranking_text(const Record& record);

}  // namespace zona::studies::search
