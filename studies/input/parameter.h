#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace zona::studies {

/// A value that a quantity may also be called by, e.g. {"water", 1000}; the value is in SI.
using NamedValue = std::pair<std::string, double>;

/// Open or closed interval of allowed values, in SI.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_allowed = true;
  bool max_allowed = true;

  bool contains(double value) const;
  bool is_everything() const;
  /// "above 0 m and at most 1 m"; empty when everything is allowed.
  std::string text(const std::string& si_unit) const;
};

/// Condition under which a key applies: the choice `key` of the same table has one of `values`.
struct Condition {
  std::string key;
  std::vector<std::string> values;

  /// `shape = "box" or "sphere"`
  std::string text() const;
};

/// Declaration of one key of a study file. `Schema` creates it; the chained calls below complete it
/// and return it.
struct Parameter {
  enum class Kind { quantity, formula, number, integer, boolean, choice, text, name, file, any };

  std::string key;  ///< dotted, e.g. "grid.cell"
  Kind kind = Kind::text;
  std::string unit;          ///< SI unit of a quantity or formula, in the notation of UDUNITS-2
  std::string default_toml;  ///< as it would stand in a study file; empty when required
  bool is_list = false;
  std::size_t exact_count = 0;         ///< length a list must have; 0 allows any but an empty one
  bool one_for_all = false;            ///< a single value may stand for a list of `exact_count`
  bool may_be_empty = false;           ///< of a list
  bool may_be_auto = false;            ///< "auto" is allowed: the study chooses
  std::vector<std::string> variables;  ///< of a formula
  std::string refers_to;               ///< of a name: the list whose items it names, if any
  std::vector<Condition> conditions;   ///< all must hold where the key stands
  std::vector<NamedValue> names;       ///< of a quantity
  std::vector<std::string> choices;    ///< of a choice
  std::vector<long> allowed;           ///< of an integer, empty for the whole range
  Range range;
  std::string symbol;         ///< as in the dissertation, e.g. "S_L"
  std::string documentation;  ///< one or two sentences, with the equation or table it stems from

  /// Allowed values in SI as an interval: "(0, 1]" is above 0 and at most 1.
  Parameter& in(const std::string& interval);
  Parameter& one_of(std::vector<long> values);
  Parameter& or_auto();
  /// or_auto, with "auto" as the default.
  Parameter& auto_by_default();
  Parameter& or_named(std::vector<NamedValue> named_values);
  Parameter& exactly(std::size_t count);
  /// A single value may stand for a list of `exactly` n equal ones.
  Parameter& or_one_for_all();
  Parameter& or_none();
  /// The key applies only where a choice of the same table, declared before, has one of the values;
  /// `choice_key` is its last part. Elsewhere the key has no value, and setting it is a problem.
  Parameter& only_with(const std::string& choice_key, std::vector<std::string> values);
  /// The same, with a condition from TableKeys::is.
  Parameter& only_where(Condition condition);
  /// Removes the default: every study file must set the key.
  Parameter& without_default();
  Parameter& called(std::string symbol_in_the_source);
  Parameter& doc(std::string sentences);

  bool is_required() const { return default_toml.empty(); }
  /// What a value must look like: "a length, above 0 m", "one of newmark, arkode, modal".
  std::string expectation() const;
  /// A value that would be accepted, as TOML text.
  std::string example() const;
};

/// "a, b or c".
std::string joined(const std::vector<std::string>& words, const std::string& last = " or ");

}  // namespace zona::studies
