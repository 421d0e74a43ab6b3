#include "studies/input/input_error.h"

#include <fmt/format.h>

namespace zona::studies {

namespace {

std::string all_problems(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += problem.text();
  }
  return text;
}

/// The longest beginning of `text` within `length` bytes that does not split a UTF-8 character.
std::string_view whole_characters(std::string_view text, std::size_t length) {
  if (text.size() <= length) return text;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  return text.substr(0, length);
}

}  // namespace

std::string Problem::text() const {
  std::string result = printable(where, 400);
  if (!key.empty()) result += ": " + printable(key);
  return result + ": " + message;
}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(all_problems(problems)), problems_(std::move(problems)) {}

InputError::InputError(Problem problem) : InputError(std::vector<Problem>{std::move(problem)}) {}

InputError::InputError(std::string where, std::string message)
    : InputError(Problem{std::move(where), "", std::move(message), 0}) {}

std::string printable(std::string_view text, std::size_t length) {
  const std::string_view shown = whole_characters(text, length);
  std::string result;
  for (const char character : shown) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += character;
    }
  }
  if (shown.size() < text.size()) result += fmt::format("... ({} characters)", text.size());
  return result;
}

}  // namespace zona::studies
