#include "studies/input/resolver.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "studies/input/interpret.h"
#include "studies/input/keys.h"
#include "studies/input/nearest.h"
#include "studies/input/unknown_key.h"

namespace zona::studies {

namespace {

/// A base may have keys of its own kind that the study does not know.
bool is_known(const TomlEntry& entry, const std::vector<const Schema*>& schemas) {
  const auto item = item_key(entry.key);
  const bool is_table = entry.value.type == TomlValue::Type::table;
  return std::any_of(schemas.begin(), schemas.end(), [&](const Schema* schema) {
    return schema->find(entry.key) != nullptr ||
           (is_table && schema->find_section(item ? item->list : entry.key) != nullptr);
  });
}

}  // namespace

Resolver::Resolver(const Schema& schema, const std::filesystem::path& file,
                   const StudySource& source)
    : configuration_(schema, file), problems_(source.problems) {
  for (const Section& section : schema.sections()) {
    if (!section.is_list) continue;
    configuration_.set_items(section.name, headings_of(source.entries, section.name));
  }
}

void Resolver::take(const SourcedEntry& source, const std::vector<const Schema*>& schemas) {
  const TomlEntry& entry = source.entry;
  const Schema& schema = configuration_.schema();
  const bool is_table = entry.value.type == TomlValue::Type::table;
  const auto item = item_key(entry.key);
  const Section* section = schema.find_section(item ? item->list : entry.key);
  const bool in_list = section != nullptr && section->is_list;
  if (section != nullptr && is_table && !in_list && !item) return;
  if (in_list) {
    const bool known =
        item && item->number() && *item->number() < configuration_.item_count(section->name);
    const bool no_items =
        !item && entry.value.type == TomlValue::Type::list && entry.value.items.empty();
    if (no_items || (known && item->rest.empty() && is_table)) return;
    if (!known) return report_unknown(source, schemas);
  }
  const Parameter* parameter = schema.find(entry.key);
  if (parameter == nullptr) return report_unknown(source, schemas);
  given_.insert(entry.key);
  std::vector<std::string> messages;
  Setting setting = interpret(*parameter, entry.value, messages);
  for (const std::string& message : messages) {
    problems_.push_back({source.where, configuration_.shown_key(entry.key), message, source.line});
  }
  if (!messages.empty()) return;
  setting.where = source.where;
  setting.line = source.line;
  setting.directory = source.directory;
  setting.is_inherited = source.is_inherited();
  configuration_.set(entry.key, std::move(setting));
}

void Resolver::report_unknown(const SourcedEntry& source,
                              const std::vector<const Schema*>& schemas) {
  const Schema& schema = configuration_.schema();
  const std::string& key = source.entry.key;
  if (source.is_inherited() && is_known(source.entry, schemas)) return;
  const auto item = item_key(key);
  const std::string table = unknown_table(schema, key);
  if (!table.empty() && !reported_tables_.insert(table).second) return;
  const Section* section = item ? schema.find_section(item->list) : nullptr;
  const bool in_list = section != nullptr && section->is_list;
  const bool is_item =
      in_list && item->number() && *item->number() < configuration_.item_count(item->list);
  std::string message;
  if (source.amends && in_list && !is_item) {
    const std::vector<std::string> names = configuration_.item_names(item->list);
    const std::string nearest = nearest_name(item->item, names);
    message = fmt::format("there is no {} \"{}\" among the {}; {}", item->list,
                          printable(item->item), names.size(),
                          nearest.empty() ? "use its name, or its number from 0"
                                          : "did you mean " + item->list + "." + nearest + "?");
  } else {
    message = unknown_key_message(schema, source.entry, schemas);
  }
  const bool whole_table = !table.empty() && item->number();
  const std::string shown = whole_table ? item->list : configuration_.shown_key(key);
  problems_.push_back({source.where, shown, message, source.line});
}

bool Resolver::is_inherited(const std::string& key) const {
  return configuration_.applies(key) && configuration_.setting(key).is_inherited;
}

Resolver::Applies Resolver::applies(const Parameter& parameter, const std::string& table) const {
  for (const Condition& condition : parameter.conditions) {
    const std::string key = table + "." + condition.key;
    if (!configuration_.applies(key)) {
      const bool invalid = given_.count(key) > 0;
      return invalid ? Applies::unknown : Applies::no;
    }
    const auto& values = condition.values;
    const std::string& choice = configuration_.choice(key);
    if (std::find(values.begin(), values.end(), choice) == values.end()) return Applies::no;
  }
  return Applies::yes;
}

void Resolver::complete() {
  const Schema& schema = configuration_.schema();
  for (const Section& section : schema.sections()) {
    if (section.is_list && configuration_.item_count(section.name) < section.least) {
      complain(section.name, fmt::format("is missing; needs at least {}; write [[{}]] and its keys "
                                         "below",
                                         section.least, section.name));
    }
  }
  for (const std::string& table : configuration_.tables()) {
    const auto item = item_key(table);
    for (const Parameter& parameter : schema.parameters()) {
      if (table_of(parameter.key) == (item ? item->list : table)) complete(parameter, table);
    }
  }
}

void Resolver::complete(const Parameter& parameter, const std::string& table) {
  const std::string key = table + "." + leaf(parameter.key);
  const bool given = given_.count(key) > 0;
  const Applies state = applies(parameter, table);
  if (state == Applies::no && given) {
    std::string where;
    for (const Condition& condition : parameter.conditions) {
      where += (where.empty() ? "" : " and ") + condition.text();
    }
    if (!is_inherited(key)) complain(key, fmt::format("applies only where {}; remove it", where));
    configuration_.unset(key);
  }
  if (given || state != Applies::yes) return;
  if (!parameter.is_required()) return configuration_.set(key, default_setting(parameter));
  const std::string example = item_key(table) ? leaf(key) : key;
  complain(key, fmt::format("is missing; needs {}; write e.g. {} = {}", parameter.expectation(),
                            example, parameter.example()));
}

void Resolver::check_names() {
  for (const Section& section : configuration_.schema().sections()) check_distinct(section.name);
  for (const std::string& table : configuration_.tables()) {
    for (const std::string& key : configuration_.keys_of(table)) {
      const Parameter& parameter = *configuration_.schema().find(key);
      if (!parameter.refers_to.empty()) check_reference(key, parameter);
    }
  }
}

void Resolver::check_distinct(const std::string& list) {
  const std::vector<std::string> names = configuration_.item_names(list);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string key = numbered_key(list, i, "name");
    const bool usable = configuration_.applies(key) && !configuration_.is_auto(key);
    const auto here = names.begin() + static_cast<std::ptrdiff_t>(i);
    if (!usable || std::find(names.begin(), here, names[i]) == here) continue;
    complain(key, fmt::format("there is a {} \"{}\" already; choose another name", list, names[i]));
  }
}

void Resolver::check_reference(const std::string& key, const Parameter& parameter) {
  if (configuration_.is_auto(key)) return;
  const std::vector<std::string> names = configuration_.item_names(parameter.refers_to);
  for (const std::string& name : configuration_.texts(key)) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string nearest = nearest_name(name, names);
    complain(key,
             fmt::format("there is no {} \"{}\"; {}", parameter.refers_to, printable(name),
                         nearest.empty() ? "there are " + printable(joined(names, " and "), 300)
                                         : "did you mean \"" + nearest + "\"?"));
  }
}

void Resolver::check_files() {
  for (const std::string& table : configuration_.tables()) {
    for (const std::string& key : configuration_.keys_of(table)) {
      if (configuration_.schema().find(key)->kind != Parameter::Kind::file) continue;
      const std::filesystem::path path = configuration_.path(key);
      std::error_code failure;
      if (path.empty() || std::filesystem::is_regular_file(path, failure)) continue;
      complain(key, fmt::format("there is no file {}; relative paths start at the study file",
                                printable(path.string(), 400)));
    }
  }
}

void Resolver::cross_check() {
  const auto attempt = [](const auto& check) {
    try {
      check();
    } catch (const MissingSetting&) {
      return;  // the value itself is reported already
    }
  };
  const Complain report = [this](const std::string& key, const std::string& message) {
    complain(key, message);
  };
  for (const CrossCheck& check : configuration_.schema().cross_checks()) {
    attempt([&] { check(configuration_, report); });
  }
  for (const auto& [list, check] : configuration_.schema().item_checks()) {
    for (const Table& item : configuration_.items(list)) {
      const Complain report_item = [&](const std::string& key, const std::string& message) {
        complain(item.key(key), message);
      };
      attempt([&, &check = check] { check(item, report_item); });
    }
  }
}

void Resolver::complain(const std::string& key, const std::string& message) {
  problems_.push_back(configuration_.problem(key, message));
}

Configuration Resolver::result() {
  if (problems_.empty()) return configuration_;
  const std::string here = configuration_.file().string() + ":";
  const auto place = [&](const Problem& problem) {
    const bool elsewhere = problem.where.rfind(here, 0) != 0;
    return std::pair(elsewhere, problem.line > 0 ? problem.line : std::numeric_limits<int>::max());
  };
  std::stable_sort(problems_.begin(), problems_.end(),
                   [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
  throw InputError(problems_);
}

}  // namespace zona::studies
