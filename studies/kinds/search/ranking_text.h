#pragma once

#include <string>

#include "studies/kinds/search/record.h"

namespace zona::studies::search {

/// The finalists as a table for people, the best first, after the reference; then what the table
/// says and which uncertain inputs make a design leave its limits. Needs verdicts.
std::string ranking_text(const Record& record);

}  // namespace zona::studies::search
