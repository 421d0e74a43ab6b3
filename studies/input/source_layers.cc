#include "studies/input/source_layers.h"

#include <algorithm>
#include <set>

#include "studies/input/keys.h"
#include "studies/input/source_items.h"

namespace zona::studies {

namespace {

/// The lists of tables that a layer gives as a whole, perhaps empty.
std::set<std::string> whole_lists(const std::vector<SourcedEntry>& layer) {
  std::set<std::string> lists;
  for (const SourcedEntry& source : layer) {
    const auto& [key, value] = source.entry;
    const auto item = item_key(key);
    if (value.type == TomlValue::Type::list && value.items.empty()) lists.insert(key);
    if (value.type == TomlValue::Type::table && item && item->number() == 0 && item->rest.empty()) {
      lists.insert(item->list);
    }
  }
  return lists;
}

}  // namespace

void amend(StudySource& source, std::vector<SourcedEntry> layer) {
  for (const std::string& list : whole_lists(layer)) erase_list(source.entries, list);
  for (SourcedEntry& entry : layer) {
    const std::string key = with_item_numbers(source.entries, entry.entry.key);
    const auto same_key = [&](const SourcedEntry& other) { return other.entry.key == key; };
    const auto found = std::find_if(source.entries.begin(), source.entries.end(), same_key);
    entry.entry.key = key;
    if (found != source.entries.end() && found->layer == entry.layer) {
      source.problems.push_back({entry.where, key, "is set twice; set it once", entry.line});
      continue;
    }
    if (found != source.entries.end()) source.entries.erase(found);
    source.entries.push_back(std::move(entry));
  }
}

}  // namespace zona::studies
