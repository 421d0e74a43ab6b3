#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studies/input/binding.h"
#include "studies/input/formula.h"
#include "studies/input/input_error.h"
#include "studies/input/schema.h"
#include "studies/input/setting.h"

namespace zona::studies {

/// Name and place of a table of a list.
struct ItemHeading {
  std::string name;   ///< its key `name`; empty if that is not a text
  std::string where;  ///< "file:line" or "--set"
  int line = 0;
};

/// A study with every parameter resolved and valid. Values in SI.
///
/// Asking for a key that the study kind does not declare, or by the wrong type, is a programming
/// error: std::logic_error.
class Configuration {
 public:
  Configuration(const Schema& schema, std::filesystem::path file);

  const std::string& kind() const { return schema_->kind(); }
  const Schema& schema() const { return *schema_; }
  /// Path of the study file, as given.
  const std::filesystem::path& file() const { return file_; }
  /// Base of relative paths in the study file.
  std::filesystem::path base_directory() const;

  bool has(const std::string& key) const { return schema_->find(key) != nullptr; }
  /// Whether the key has a value; false where its conditions do not hold (Parameter::only_with).
  bool applies(const std::string& key) const { return settings_.count(key) > 0; }
  double quantity(const std::string& key) const;  ///< SI; a named choice gives its value
  double number(const std::string& key) const;
  long integer(const std::string& key) const;
  bool boolean(const std::string& key) const;
  const std::string& choice(const std::string& key) const;
  const std::string& text(const std::string& key) const;         ///< as written; any type of text
  std::filesystem::path path(const std::string& key) const;      ///< absolute; empty means none
  std::vector<double> quantities(const std::string& key) const;  ///< SI
  Formula formula(const std::string& key) const;
  std::vector<Formula> formulas(const std::string& key) const;
  std::vector<double> numbers(const std::string& key) const;
  std::vector<long> integers(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;  ///< as written, e.g. fluid names

  /// @{
  /// Typed access to a table, not a list, by the struct T that the schema binds to it or by a
  /// member of T. Asking for what the schema does not bind is a programming error.
  template <class T>
  T read() const;
  template <class T, class M>
  M value(M T::*member) const;
  template <class T, class M>
  std::string key(M T::*member) const;
  template <class T, class M>
  Problem problem(M T::*member, const std::string& message) const;
  template <class T, class M>
  bool is_default(M T::*member) const;
  /// @}
  template <class T>
  Table table() const;
  /// All items of the list that is bound to T.
  template <class T>
  std::vector<T> read_all() const;
  /// The tables of that list.
  template <class T>
  std::vector<Table> items() const;

  /// The table of that name, e.g. "grid" or "body.0".
  Table table(const std::string& name) const;
  /// The tables of a list, in the order of the file.
  std::vector<Table> items(const std::string& list) const;
  std::size_t item_count(const std::string& list) const { return headings(list).size(); }
  const std::vector<ItemHeading>& headings(const std::string& list) const;
  std::vector<std::string> item_names(const std::string& list) const;
  /// All tables in the order of the schema: "grid", "body.0", "body.1", ...
  std::vector<std::string> tables() const;
  /// Keys of a table that have a value, in the order of the schema.
  std::vector<std::string> keys_of(const std::string& table) const;
  /// The key with items by name: "body.left.density" for "body.0.density".
  std::string shown_key(const std::string& key) const;

  bool is_auto(const std::string& key) const;
  bool is_default(const std::string& key) const;
  int line_of(const std::string& key) const;  ///< 0 for defaults and overrides
  /// A problem of a key, located at its value; without a value at the heading of its table in a
  /// list, or at the file.
  Problem problem(const std::string& key, const std::string& message) const;
  const Setting& setting(const std::string& key) const;

  void set(const std::string& key, Setting setting);
  void unset(const std::string& key) { settings_.erase(key); }
  void set_items(const std::string& list, std::vector<ItemHeading> headings);

 private:
  const Setting& of_kind(const std::string& key, Parameter::Kind kind, bool is_list) const;

  const Schema* schema_;
  std::filesystem::path file_;
  std::map<std::string, Setting> settings_;
  std::map<std::string, std::vector<ItemHeading>> headings_;
};

/// One table of a study, e.g. [grid] or the first [[body]]. Its members take the last part of a key
/// ("cell"). Must not outlive its configuration.
class Table {
 public:
  Table(const Configuration& study, std::string name) : study_(&study), name_(std::move(name)) {}

  const Configuration& study() const { return *study_; }
  std::string key(const std::string& leaf) const { return name_ + "." + leaf; }
  /// The item's name; its number where it is "auto".
  std::string name() const;
  Problem problem(const std::string& leaf, const std::string& message) const {
    return study_->problem(key(leaf), message);
  }

  /// @{
  /// Typed access to this table, which must be bound to T.
  template <class T>
  T read() const;
  template <class T, class M>
  M value(M T::*member) const;
  template <class T, class M>
  std::string key(M T::*member) const;
  /// The last part of a member's key.
  template <class T, class M>
  const std::string& leaf(M T::*member) const;
  template <class T, class M>
  bool applies(M T::*member) const;
  template <class T, class M>
  Problem problem(M T::*member, const std::string& message) const;
  /// @}

  const Setting& setting(const std::string& leaf) const { return study_->setting(key(leaf)); }
  bool applies(const std::string& leaf) const { return study_->applies(key(leaf)); }
  bool is_auto(const std::string& leaf) const { return study_->is_auto(key(leaf)); }
  double quantity(const std::string& leaf) const { return study_->quantity(key(leaf)); }
  double number(const std::string& leaf) const { return study_->number(key(leaf)); }
  long integer(const std::string& leaf) const { return study_->integer(key(leaf)); }
  bool boolean(const std::string& leaf) const { return study_->boolean(key(leaf)); }
  const std::string& choice(const std::string& leaf) const { return study_->choice(key(leaf)); }
  const std::string& text(const std::string& leaf) const { return study_->text(key(leaf)); }
  Formula formula(const std::string& leaf) const { return study_->formula(key(leaf)); }
  std::vector<double> quantities(const std::string& leaf) const {
    return study_->quantities(key(leaf));
  }
  std::vector<double> numbers(const std::string& leaf) const { return study_->numbers(key(leaf)); }
  std::vector<long> integers(const std::string& leaf) const { return study_->integers(key(leaf)); }
  std::vector<std::string> texts(const std::string& leaf) const { return study_->texts(key(leaf)); }
  std::vector<Formula> formulas(const std::string& leaf) const {
    return study_->formulas(key(leaf));
  }

 private:
  const Configuration* study_;
  std::string name_;
};

template <class T>
T Table::read() const {
  T result{};
  for (const BoundKey<T>& bound : study_->schema().template binding<T>().keys)
    if (applies(bound.leaf)) bound.read(*this, result);
  return result;
}

template <class T, class M>
const std::string& Table::leaf(M T::*member) const {
  return study_->schema().template binding<T>().of(member).leaf;
}

template <class T, class M>
M Table::value(M T::*member) const {
  const BoundKey<T>& bound = study_->schema().template binding<T>().of(member);
  setting(bound.leaf);  // throws where there is no value
  T result{};
  bound.read(*this, result);
  return result.*member;
}

template <class T, class M>
std::string Table::key(M T::*member) const {
  return key(leaf(member));
}

template <class T, class M>
bool Table::applies(M T::*member) const {
  return applies(leaf(member));
}

template <class T, class M>
Problem Table::problem(M T::*member, const std::string& message) const {
  return problem(leaf(member), message);
}

template <class T>
Table Configuration::table() const {
  return table(schema_->binding<T>().section);
}

template <class T>
T Configuration::read() const {
  return table<T>().template read<T>();
}

template <class T, class M>
M Configuration::value(M T::*member) const {
  return table<T>().value(member);
}

template <class T, class M>
std::string Configuration::key(M T::*member) const {
  const Binding<T>& binding = schema_->binding<T>();
  return binding.section + "." + binding.of(member).leaf;
}

template <class T, class M>
Problem Configuration::problem(M T::*member, const std::string& message) const {
  return problem(key(member), message);
}

template <class T, class M>
bool Configuration::is_default(M T::*member) const {
  return is_default(key(member));
}

template <class T>
std::vector<Table> Configuration::items() const {
  return items(schema_->binding<T>().section);
}

template <class T>
std::vector<T> Configuration::read_all() const {
  std::vector<T> all;
  for (const Table& table : items<T>()) all.push_back(table.read<T>());
  return all;
}

/// A cross-check asked for a value that is itself invalid; the loader skips such a check.
class MissingSetting : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Reads a study file, applies overrides of the form `key=TOML-value`, fills in the defaults and
/// checks everything. Throws InputError with all problems of the file and the overrides.
/// The schemas must outlive the configuration.
Configuration load_configuration(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides,
                                 const std::vector<const Schema*>& schemas);

}  // namespace zona::studies
