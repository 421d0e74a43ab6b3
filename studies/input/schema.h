#pragma once

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

#include "studies/input/binding.h"
#include "studies/input/parameter.h"

namespace zona::studies {

class Configuration;
class Table;

/// Reports a problem of a key.
using Complain = std::function<void(const std::string& key, const std::string& message)>;

/// Checks several values together. Skipped if a value that it asks for is invalid.
using CrossCheck = std::function<void(const Configuration&, const Complain&)>;

/// The same for one table of a list; `complain` takes the last part of a key.
using ItemCheck = std::function<void(const Table&, const Complain&)>;

/// A table of a study file, e.g. [grid], or a list of tables, e.g. [[body]].
struct Section {
  std::string name;
  std::string documentation;
  bool is_list = false;
  std::size_t least = 0;  ///< minimum number of tables in a list

  /// As it stands in a study file: "[grid]", "[[body]]".
  std::string heading() const { return is_list ? "[[" + name + "]]" : "[" + name + "]"; }
};

/// The keys of one study kind. Every key declares its default in the user's own notation:
///
///     Schema schema("drop", "A drop falls on a plate.");
///     schema.section("drop", "The drop.");
///     schema.quantity("drop.diameter", "m", "2 mm").in("(0, 0.1]").doc("Diameter at rest.");
///
/// A list of tables is declared like a single table; the values of its second table have keys such
/// as "wall.1.height" (or, where its name is "left", "wall.left.height"):
///
///     schema.list("wall", "Walls.");
///     schema.quantity("wall.height", "m", "2 mm").doc("Height.");
///
/// The reference that a call returns is for chaining only; the next declaration invalidates it.
class Schema {
 public:
  Schema(std::string kind, std::string summary);

  /// Declares the table that the following keys belong to.
  void section(const std::string& name, const std::string& documentation);

  /// Declares a list of `least` tables or more. Each has a key `name`, which must be given or is by
  /// default "auto", its number.
  void list(const std::string& name, const std::string& documentation, std::size_t least,
            bool must_be_named);

  Parameter& quantity(const std::string& key, const std::string& unit, const std::string& value);
  Parameter& quantities(const std::string& key, const std::string& unit,
                        const std::vector<std::string>& values);
  /// A function of `variables` (in SI), or a quantity for a constant.
  Parameter& formula(const std::string& key, const std::string& unit,
                     const std::vector<std::string>& variables, const std::string& value);
  Parameter& formulas(const std::string& key, const std::string& unit,
                      const std::vector<std::string>& variables,
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
  Parameter& texts(const std::string& key, const std::vector<std::string>& values);
  /// Values for another key, of its type; none by default.
  Parameter& anything(const std::string& key);
  /// One such value, "auto" by default.
  Parameter& bound(const std::string& key);
  /// The name of an item of the list `refers_to`; it has no default.
  Parameter& reference(const std::string& key, const std::string& refers_to);
  Parameter& references(const std::string& key, const std::string& refers_to);
  /// A file that is read; relative paths start at the study file. An empty path means none.
  Parameter& file(const std::string& key, const std::string& value);

  /// Binds keys of a table, or of the items of a list, to members of T (TableKeys).
  template <class T>
  Binding<T>& bind(const std::string& section);
  /// The keys bound to T. Throws std::logic_error if there are none.
  template <class T>
  const Binding<T>& binding() const;
  template <class T>
  bool binds() const {
    return bindings_.count(typeid(T)) > 0;
  }

  /// Restricts the checks declared next to studies for which `applies` holds; an empty one lifts
  /// the restriction.
  void check_only_where(std::function<bool(const Configuration&)> applies) {
    checked_ = std::move(applies);
  }
  void check(CrossCheck cross_check);
  void check_each(const std::string& list, ItemCheck check);
  /// Checks one table, or each item of a list, declared before.
  void check_table(const std::string& name, ItemCheck check);

  const std::string& kind() const { return kind_; }
  const std::string& summary() const { return summary_; }
  const std::vector<Section>& sections() const { return sections_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  const std::vector<CrossCheck>& cross_checks() const { return cross_checks_; }
  /// Checks of each item of a list, with the list's name.
  const std::vector<std::pair<std::string, ItemCheck>>& item_checks() const { return item_checks_; }
  /// The declaration of a key, also of one in a numbered item ("body.0.density"); nullptr when
  /// there is no such key.
  const Parameter* find(const std::string& key) const;
  /// The table or list of that name; nullptr when there is none.
  const Section* find_section(const std::string& name) const;
  std::vector<std::string> keys() const;

 private:
  Parameter& add(const std::string& key, Parameter::Kind kind, std::string default_toml);

  std::string kind_;
  std::string summary_;
  std::vector<Section> sections_;
  std::vector<Parameter> parameters_;
  std::map<std::type_index, std::shared_ptr<void>> bindings_;  ///< Binding<T> by T
  std::function<bool(const Configuration&)> checked_;          ///< condition of the next checks
  std::vector<CrossCheck> cross_checks_;
  std::vector<std::pair<std::string, ItemCheck>> item_checks_;
};

template <class T>
Binding<T>& Schema::bind(const std::string& section) {
  std::shared_ptr<void>& slot = bindings_[typeid(T)];
  if (slot == nullptr) slot = std::make_shared<Binding<T>>(Binding<T>{section, {}});
  auto& binding = *static_cast<Binding<T>*>(slot.get());
  if (binding.section != section)
    throw std::logic_error("one struct is bound to [" + binding.section + "] and [" + section +
                           "]");
  return binding;
}

template <class T>
const Binding<T>& Schema::binding() const {
  const auto found = bindings_.find(typeid(T));
  if (found == bindings_.end())
    throw std::logic_error("a " + kind_ + " study has no table for this struct");
  return *static_cast<const Binding<T>*>(found->second.get());
}

}  // namespace zona::studies
