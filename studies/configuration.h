#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studies/input_error.h"
#include "studies/schema.h"
#include "studies/toml_document.h"

namespace zona::studies {

/// The value of one key, checked against its declaration.
struct Setting {
  TomlValue written;               ///< as the user (or the default) has it
  std::vector<double> numbers;     ///< one per item; quantities in SI
  std::vector<std::string> texts;  ///< one per item, as written: "mercury", "13.5 um"
  bool is_auto = false;
  bool is_default = false;
  std::string where;  ///< "file:line" or "--set"; empty for a default
  int line = 0;       ///< 0 for defaults and overrides
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
  /// The study file as it was named.
  const std::filesystem::path& file() const { return file_; }
  /// Where relative paths in the study file start.
  std::filesystem::path base_directory() const;

  bool has(const std::string& key) const { return schema_->find(key) != nullptr; }
  double quantity(const std::string& key) const;  ///< SI; a named choice gives its value
  double number(const std::string& key) const;
  long integer(const std::string& key) const;
  bool boolean(const std::string& key) const;
  const std::string& choice(const std::string& key) const;
  const std::string& text(const std::string& key) const;     ///< as written, of any kind of text
  std::filesystem::path path(const std::string& key) const;  ///< absolute; empty means none
  std::vector<double> quantities(const std::string& key) const;  ///< SI
  std::vector<double> numbers(const std::string& key) const;
  std::vector<long> integers(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;  ///< as written, e.g. fluid names

  bool is_auto(const std::string& key) const;
  bool is_default(const std::string& key) const;
  int line_of(const std::string& key) const;  ///< 0 for defaults and overrides
  /// "file:line", "--set", or the file for a default.
  std::string where(const std::string& key) const;
  const Setting& setting(const std::string& key) const;

  void set(const std::string& key, Setting setting);

 private:
  const Setting& of_kind(const std::string& key, Parameter::Kind kind, bool is_list) const;

  const Schema* schema_;
  std::filesystem::path file_;
  std::map<std::string, Setting> settings_;
};

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

/// The same for the study kinds of this program.
Configuration load_configuration(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides = {});

}  // namespace zona::studies
