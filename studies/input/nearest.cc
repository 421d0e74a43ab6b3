#include "studies/input/nearest.h"

#include <algorithm>

namespace zona::studies {

namespace {

std::string_view last_part(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

std::size_t tolerated_distance(std::string_view name) {
  return (name.size() + 2) / 3;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names) {
  constexpr std::size_t longest = 100;  // nobody mistypes a name into something longer
  if (wanted.empty() || wanted.size() > longest) return {};
  std::string best;
  std::size_t best_distance = longest;
  for (const std::string& name : names) {
    const std::size_t whole = edit_distance(wanted, name);
    const std::size_t part = edit_distance(last_part(wanted), last_part(name));
    const bool same_word = part <= tolerated_distance(last_part(name));
    const bool beginning = wanted.size() >= 3 && name.rfind(wanted, 0) == 0;
    if (whole > tolerated_distance(name) && !same_word && !beginning) continue;
    const std::size_t distance = whole + 3 * part;  // the last part says what was meant
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace zona::studies
