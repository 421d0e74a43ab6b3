#pragma once

#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/input/study_source.h"

namespace zona::studies {

/// Where the tables of a list begin, e.g. all [[body]], in their order.
std::vector<ItemHeading> headings_of(const std::vector<SourcedEntry>& entries,
                                     const std::string& list);

/// "body.0.density" for "body.left.density", where the first body is called left; any other key as
/// it is.
std::string with_item_numbers(const std::vector<SourcedEntry>& entries, const std::string& key);

/// Takes a list with all that belongs to it out of the entries.
void erase_list(std::vector<SourcedEntry>& entries, const std::string& list);

}  // namespace zona::studies
