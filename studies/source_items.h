#pragma once

#include <string>
#include <vector>

#include "studies/study_source.h"

namespace zona::studies {

/// A table of a list as it stands in a source, before its keys are known.
struct SourceItem {
  std::string name;   ///< what its key `name` says; empty when that is no text
  std::string where;  ///< of its heading
  int line = 0;
};

/// The tables of a list, e.g. all [[body]], in their order.
std::vector<SourceItem> items_of(const std::vector<SourcedEntry>& entries, const std::string& list);

/// "body.0.density" for "body.left.density", where the first body is called left; any other key as
/// it is.
std::string with_item_numbers(const std::vector<SourcedEntry>& entries, const std::string& key);

/// Takes a list with all that belongs to it out of the entries.
void erase_list(std::vector<SourcedEntry>& entries, const std::string& list);

}  // namespace zona::studies
