#pragma once

#include "studies/kinds/search/record.h"
#include "studies/run/run_directory.h"
#include "studies/run/session.h"

namespace zona::studies::search {

/// designs.csv: every design that was tried, with the measures of its tip.
void write_designs(const Record& record, const RunDirectory& directory);

/// The results, and where a search has been carried through samples.csv, trials.csv, ranking.txt
/// and the ranked designs as study files in candidates/.
void write_record(const Record& record, Session& session);

}  // namespace zona::studies::search
