#include "studies/input/source_items.h"

#include <algorithm>

#include "studies/input/keys.h"

namespace zona::studies {

std::vector<ItemHeading> headings_of(const std::vector<SourcedEntry>& entries,
                                     const std::string& list) {
  std::vector<ItemHeading> headings;
  for (const SourcedEntry& source : entries) {
    const TomlEntry& entry = source.entry;
    if (entry.value.type == TomlValue::Type::table &&
        entry.key == numbered_key(list, headings.size(), "")) {
      headings.push_back({"", source.where, source.line});
    }
  }
  for (const SourcedEntry& source : entries) {
    const auto key = item_key(source.entry.key);
    if (!key || key->list != list || key->rest != "name") continue;
    const auto number = key->number();
    if (number && *number < headings.size()) headings[*number].name = source.entry.value.text;
  }
  return headings;
}

std::string with_item_numbers(const std::vector<SourcedEntry>& entries, const std::string& key) {
  const auto wanted = item_key(key);
  if (!wanted || wanted->number()) return key;
  for (const SourcedEntry& source : entries) {
    const auto candidate = item_key(source.entry.key);
    if (!candidate || candidate->list != wanted->list || candidate->rest != "name") continue;
    const auto number = candidate->number();
    if (number && source.entry.value.text == wanted->item) {
      return numbered_key(wanted->list, *number, wanted->rest);
    }
  }
  return key;
}

void erase_list(std::vector<SourcedEntry>& entries, const std::string& list) {
  const auto belongs = [&](const SourcedEntry& source) {
    return source.entry.key == list || source.entry.key.rfind(list + ".", 0) == 0;
  };
  entries.erase(std::remove_if(entries.begin(), entries.end(), belongs), entries.end());
}

}  // namespace zona::studies
