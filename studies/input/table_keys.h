#pragma once

#include <string>
#include <utility>
#include <vector>

#include "studies/input/configuration.h"

namespace zona::studies {

/// Declares keys of a table, each together with the member of T that it is read into. Other code
/// then needs only this struct:
///
///     struct Drop {
///       double diameter;  ///< [m]
///       Surface surface;
///     };
///
///     TableKeys<Drop> keys(schema, "drop", "The drop.");
///     keys.quantity("diameter", &Drop::diameter, "m", "2 mm").in("(0, 0.1]").doc("At rest.");
///     keys.choice("surface", &Drop::surface, kSurfaces).doc("Clean, or covered.");
///
///     const Drop drop = study.read<Drop>();
///
/// Arguments are those of the calls of Schema with the same names; the type of a member follows
/// from `assign` in binding.h: std::optional for what may be "auto".
template <class T>
class TableKeys {
 public:
  /// Keys of a section that has been opened.
  TableKeys(Schema& schema, const std::string& section)
      : schema_(schema), section_(section), binding_(schema.bind<T>(section)) {}

  /// Opens a section.
  TableKeys(Schema& schema, const std::string& section, const std::string& documentation)
      : TableKeys(schema, section) {
    schema.section(section, documentation);
  }

  template <class M, class C>
  Parameter& quantity(const char* leaf, M C::*member, const char* unit, const std::string& value) {
    bind(leaf, member);
    return with_conditions(schema_.quantity(key(leaf), unit, value));
  }
  template <class M, class C>
  Parameter& quantities(const char* leaf, M C::*member, const char* unit,
                        const std::vector<std::string>& values) {
    bind(leaf, member);
    return with_conditions(schema_.quantities(key(leaf), unit, values));
  }
  template <class M, class C>
  Parameter& number(const char* leaf, M C::*member, double value) {
    bind(leaf, member);
    return with_conditions(schema_.number(key(leaf), value));
  }
  template <class M, class C>
  Parameter& numbers(const char* leaf, M C::*member, const std::vector<double>& values) {
    bind(leaf, member);
    return with_conditions(schema_.numbers(key(leaf), values));
  }
  template <class M, class C>
  Parameter& integer(const char* leaf, M C::*member, long value) {
    bind(leaf, member);
    return with_conditions(schema_.integer(key(leaf), value));
  }
  template <class M, class C>
  Parameter& integers(const char* leaf, M C::*member, const std::vector<long>& values) {
    bind(leaf, member);
    return with_conditions(schema_.integers(key(leaf), values));
  }
  template <class C>
  Parameter& boolean(const char* leaf, bool C::*member, bool value) {
    bind(leaf, member);
    return with_conditions(schema_.boolean(key(leaf), value));
  }
  /// The first word is the default.
  template <class M, class C>
  Parameter& choice(const char* leaf, M C::*member, const Words<M>& words) {
    bind(leaf, member, [=](const Table& table, T& result) {
      result.*member = value_of(words, table.setting(leaf).texts.at(0));
    });
    return with_conditions(schema_.choice(key(leaf), texts_of(words)));
  }
  /// With another default than the first word.
  template <class M, class C>
  Parameter& choice(const char* leaf, M C::*member, const Words<M>& words, const M& preset) {
    Parameter& parameter = choice(leaf, member, words);
    parameter.default_toml = quoted_toml(word_for(words, preset));
    return parameter;
  }
  template <class M, class C>
  Parameter& choices(const char* leaf, std::vector<M> C::*member, const Words<M>& words,
                     const std::vector<std::string>& values) {
    bind(leaf, member, [=](const Table& table, T& result) {
      (result.*member).clear();
      for (const std::string& text : table.setting(leaf).texts)
        (result.*member).push_back(value_of(words, text));
    });
    return with_conditions(schema_.choices(key(leaf), texts_of(words), values));
  }
  template <class M, class C>
  Parameter& text(const char* leaf, M C::*member, const std::string& value) {
    bind(leaf, member);
    return with_conditions(schema_.text(key(leaf), value));
  }
  template <class M, class C>
  Parameter& texts(const char* leaf, M C::*member, const std::vector<std::string>& values) {
    bind(leaf, member);
    return with_conditions(schema_.texts(key(leaf), values));
  }
  /// Values for another key, as written.
  template <class C>
  Parameter& anything(const char* leaf, std::vector<TomlValue> C::*member) {
    bind(leaf, member);
    return with_conditions(schema_.anything(key(leaf)));
  }
  /// One such value, empty for "auto".
  template <class C>
  Parameter& bound(const char* leaf, std::optional<TomlValue> C::*member) {
    bind(leaf, member);
    return with_conditions(schema_.bound(key(leaf)));
  }
  /// A key that `declare` declares, given the schema and the full key.
  template <class M, class C, class Declare>
  Parameter& declared(const char* leaf, M C::*member, const Declare& declare) {
    bind(leaf, member);
    return with_conditions(declare(schema_, key(leaf)));
  }
  template <class M, class C>
  Parameter& reference(const char* leaf, M C::*member, const std::string& refers_to) {
    bind(leaf, member);
    return with_conditions(schema_.reference(key(leaf), refers_to));
  }
  template <class M, class C>
  Parameter& references(const char* leaf, M C::*member, const std::string& refers_to) {
    bind(leaf, member);
    return with_conditions(schema_.references(key(leaf), refers_to));
  }
  /// The member is an absolute path, empty for none.
  template <class C>
  Parameter& file(const char* leaf, std::filesystem::path C::*member, const std::string& value) {
    bind(leaf, member, [=](const Table& table, T& result) {
      result.*member = table.study().path(table.key(leaf));
    });
    return with_conditions(schema_.file(key(leaf), value));
  }
  template <class C>
  Parameter& formula(const char* leaf, std::optional<Formula> C::*member, const char* unit,
                     const std::vector<std::string>& variables, const std::string& value) {
    bind(leaf, member, [=](const Table& table, T& result) {
      if (!table.is_auto(leaf)) result.*member = table.formula(leaf);
    });
    return with_conditions(schema_.formula(key(leaf), unit, variables, value));
  }
  template <class C>
  Parameter& formulas(const char* leaf, std::vector<Formula> C::*member, const char* unit,
                      const std::vector<std::string>& variables,
                      const std::vector<std::string>& values) {
    bind(leaf, member, [=](const Table& table, T& result) {
      if (!table.is_auto(leaf)) result.*member = table.formulas(leaf);
    });
    return with_conditions(schema_.formulas(key(leaf), unit, variables, values));
  }

  /// All following keys apply only under these conditions (Parameter::only_with).
  void apply_only_where(std::vector<Condition> conditions) { conditions_ = std::move(conditions); }
  /// The condition that a choice, declared before, has one of these values.
  template <class M, class C>
  Condition is(M C::*member, const Words<M>& words, const std::vector<M>& values) const {
    Condition condition{binding_.of(static_cast<M T::*>(member)).leaf, {}};
    for (const M& value : values) condition.values.push_back(word_for(words, value));
    return condition;
  }

  Schema& schema() { return schema_; }
  const std::string& section() const { return section_; }

 private:
  using Read = std::function<void(const Table&, T&)>;

  std::string key(const std::string& leaf) const { return section_ + "." + leaf; }

  template <class M, class C>
  void bind(const char* leaf, M C::*member) {
    bind(leaf, member,
         [=](const Table& table, T& result) { assign(table.setting(leaf), result.*member); });
  }
  template <class M, class C>
  void bind(const char* leaf, M C::*member, Read read) {
    binding_.keys.push_back({leaf, static_cast<M T::*>(member), std::move(read)});
  }
  Parameter& with_conditions(Parameter& parameter) const {
    parameter.conditions.insert(parameter.conditions.end(), conditions_.begin(), conditions_.end());
    return parameter;
  }

  Schema& schema_;
  std::string section_;
  Binding<T>& binding_;
  std::vector<Condition> conditions_;
};

}  // namespace zona::studies
