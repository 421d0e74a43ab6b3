#pragma once

#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/input/study_source.h"

namespace zona::studies {

/// Headings of the tables of a list, e.g. of all [[body]], in order.
std::vector<ItemHeading> headings_of(const std::vector<SourcedEntry>& entries,
                                     const std::string& list);

/// The key with the item by number: "body.0.density" for "body.left.density" if the first body is
/// called left. Other keys stay.
std::string with_item_numbers(const std::vector<SourcedEntry>& entries, const std::string& key);

/// Removes a list and all its keys from the entries.
void erase_list(std::vector<SourcedEntry>& entries, const std::string& list);

}  // namespace zona::studies
