#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace zona::studies {

class Configuration;

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

/// Everything that is declared about one key of a study file. Built by the calls of `Schema` and
/// completed by the chained calls below; each returns the parameter itself.
struct Parameter {
  enum class Kind { quantity, number, integer, boolean, choice, text, file };

  std::string key;  ///< dotted, e.g. "grid.cell"
  Kind kind = Kind::text;
  std::string unit;          ///< SI unit of a quantity, in the notation of UDUNITS-2
  std::string default_toml;  ///< as it would stand in a study file; empty when required
  bool is_list = false;
  std::size_t exact_count = 0;       ///< length a list must have; 0 allows any but an empty one
  bool may_be_empty = false;         ///< of a list
  bool may_be_auto = false;          ///< "auto" is allowed: the study chooses
  std::vector<NamedValue> names;     ///< of a quantity
  std::vector<std::string> choices;  ///< of a choice
  std::vector<long> allowed;         ///< of an integer, empty for the whole range
  Range range;
  std::string symbol;         ///< as in the dissertation, e.g. "S_L"
  std::string documentation;  ///< one or two sentences, with the equation or table it stems from

  /// Allowed values in SI as an interval: "(0, 1]" is above 0 and at most 1.
  Parameter& in(const std::string& interval);
  Parameter& one_of(std::vector<long> values);
  Parameter& or_auto();
  Parameter& or_named(std::vector<NamedValue> named_values);
  Parameter& exactly(std::size_t count);
  Parameter& or_none();
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

/// Reports what a cross-check found against a key.
using Complain = std::function<void(const std::string& key, const std::string& message)>;

/// Looks at several values together. It runs only when the values that it asks for are valid by
/// themselves.
using CrossCheck = std::function<void(const Configuration&, const Complain&)>;

/// A table of a study file, e.g. [grid].
struct Section {
  std::string name;
  std::string documentation;
};

/// The keys of one study kind. Every key declares its default in the user's own notation:
///
///     Schema schema("drop", "A drop falls on a plate.");
///     schema.section("drop", "The drop.");
///     schema.quantity("drop.diameter", "m", "2 mm").in("(0, 0.1]").doc("Diameter at rest.");
///
/// The reference that a call returns is for chaining only; the next declaration invalidates it.
class Schema {
 public:
  Schema(std::string kind, std::string summary);

  /// Declares the table that the following keys belong to.
  void section(const std::string& name, const std::string& documentation);

  Parameter& quantity(const std::string& key, const std::string& unit, const std::string& value);
  Parameter& quantities(const std::string& key, const std::string& unit,
                        const std::vector<std::string>& values);
  Parameter& number(const std::string& key, double value);
  Parameter& numbers(const std::string& key, const std::vector<double>& values);
  Parameter& integer(const std::string& key, long value);
  Parameter& integers(const std::string& key, const std::vector<long>& values);
  Parameter& boolean(const std::string& key, bool value);
  /// The first choice is the default.
  Parameter& choice(const std::string& key, const std::vector<std::string>& choices);
  Parameter& choices(const std::string& key, const std::vector<std::string>& allowed,
                     const std::vector<std::string>& values);
  Parameter& text(const std::string& key, const std::string& value);
  /// A file that is read; relative paths start at the study file. An empty path means none.
  Parameter& file(const std::string& key, const std::string& value);

  void check(CrossCheck cross_check);

  const std::string& kind() const { return kind_; }
  const std::string& summary() const { return summary_; }
  const std::vector<Section>& sections() const { return sections_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  const std::vector<CrossCheck>& cross_checks() const { return cross_checks_; }
  /// nullptr when there is no such key.
  const Parameter* find(const std::string& key) const;
  std::vector<std::string> keys() const;

 private:
  Parameter& add(const std::string& key, Parameter::Kind kind, std::string default_toml);

  std::string kind_;
  std::string summary_;
  std::vector<Section> sections_;
  std::vector<Parameter> parameters_;
  std::vector<CrossCheck> cross_checks_;
};

/// "a, b or c".
std::string joined(const std::vector<std::string>& words, const std::string& last = " or ");

}  // namespace zona::studies
