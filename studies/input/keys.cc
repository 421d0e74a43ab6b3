#include "studies/input/keys.h"

#include <charconv>

namespace zona::studies {

std::string leaf(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

std::string table_of(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::optional<std::size_t> ItemKey::number() const {
  std::size_t value = 0;
  const char* const end = item.data() + item.size();
  const auto [rest_of_text, failure] = std::from_chars(item.data(), end, value);
  if (failure != std::errc() || rest_of_text != end) return {};
  return value;
}

std::optional<ItemKey> item_key(const std::string& key) {
  const std::size_t first = key.find('.');
  if (first == std::string::npos) return {};
  const std::size_t second = key.find('.', first + 1);
  ItemKey result{key.substr(0, first), key.substr(first + 1, second - first - 1), ""};
  if (second != std::string::npos) result.rest = key.substr(second + 1);
  return result;
}

std::string numbered_key(const std::string& list, std::size_t number, const std::string& rest) {
  const std::string item = list + "." + std::to_string(number);
  return rest.empty() ? item : item + "." + rest;
}

}  // namespace zona::studies
