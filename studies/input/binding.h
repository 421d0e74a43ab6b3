#pragma once

#include <Eigen/Core>
#include <any>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "studies/input/formula.h"
#include "studies/input/setting.h"

namespace zona::studies {

class Table;

/// A word of a study file and its value. One list both declares and reads a choice, so every word
/// has a value.
template <class T>
struct Word {
  const char* word;
  T value;
};

template <class T>
using Words = std::vector<Word<T>>;

/// The words of such a list, in order.
template <class T>
std::vector<std::string> texts_of(const Words<T>& words) {
  std::vector<std::string> texts;
  for (const Word<T>& word : words) texts.emplace_back(word.word);
  return texts;
}

/// The word of a value.
template <class T>
std::string word_for(const Words<T>& words, const T& value) {
  for (const Word<T>& word : words)
    if (word.value == value) return word.word;
  throw std::logic_error("a choice has no word for one of its values");
}

/// The value of a word.
template <class T>
T value_of(const Words<T>& words, const std::string& text) {
  for (const Word<T>& word : words)
    if (text == word.word) return word.value;
  throw std::logic_error("a choice has no value for the word " + text);
}

/// A quantity that may also be given by name: "water" or "1000 kg/m^3".
struct NamedQuantity {
  std::string text;  ///< as the user wrote it
  double value = 0;  ///< in SI
};

/// @{
/// The value of a setting as the type of a member. Quantities are in SI.
inline void assign(const Setting& setting, double& value) {
  value = setting.numbers.at(0);
}
inline void assign(const Setting& setting, int& value) {
  value = static_cast<int>(setting.numbers.at(0));
}
inline void assign(const Setting& setting, long& value) {
  value = static_cast<long>(setting.numbers.at(0));
}
inline void assign(const Setting& setting, std::size_t& value) {
  value = static_cast<std::size_t>(setting.numbers.at(0));
}
inline void assign(const Setting& setting, bool& value) {
  value = setting.written.boolean;
}
inline void assign(const Setting& setting, std::string& value) {
  value = setting.texts.at(0);
}
inline void assign(const Setting& setting, NamedQuantity& value) {
  value = {setting.texts.at(0), setting.numbers.at(0)};
}
inline void assign(const Setting& setting, std::vector<double>& value) {
  value = setting.numbers;
}
inline void assign(const Setting& setting, std::vector<std::string>& value) {
  value = setting.texts;
}
inline void assign(const Setting& setting, std::vector<NamedQuantity>& value) {
  value.clear();
  for (std::size_t i = 0; i < setting.texts.size(); ++i)
    value.push_back({setting.texts[i], setting.numbers[i]});
}
inline void assign(const Setting& setting, Eigen::Vector3d& value) {
  value = {setting.numbers.at(0), setting.numbers.at(1), setting.numbers.at(2)};
}
/// The value as written, of any type.
inline void assign(const Setting& setting, TomlValue& value) {
  value = setting.written;
}
inline void assign(const Setting& setting, std::vector<TomlValue>& value) {
  value = setting.written.items;
}
template <std::size_t count>
void assign(const Setting& setting, std::array<int, count>& value) {
  for (std::size_t i = 0; i < count; ++i) value[i] = static_cast<int>(setting.numbers.at(i));
}
/// Empty for "auto".
template <class M>
void assign(const Setting& setting, std::optional<M>& value) {
  value.reset();
  if (!setting.is_auto) assign(setting, value.emplace());
}
/// @}

/// A key of a table and the member of T that it is read into.
template <class T>
struct BoundKey {
  std::string leaf;                            ///< last part of the key
  std::any member;                             ///< pointer to the member
  std::function<void(const Table&, T&)> read;  ///< assigns the member
};

/// Keys of one table of a study file, each with the member of T that it is read into.
template <class T>
struct Binding {
  std::string section;  ///< the table, or the list whose items are read
  std::vector<BoundKey<T>> keys;

  /// The key of a member. A member that no key is bound to is a programming error.
  template <class M>
  const BoundKey<T>& of(M T::*member) const {
    for (const BoundKey<T>& key : keys) {
      const auto* bound = std::any_cast<M T::*>(&key.member);
      if (bound != nullptr && *bound == member) return key;
    }
    throw std::logic_error("no key of [" + section + "] is bound to this member");
  }
};

}  // namespace zona::studies
