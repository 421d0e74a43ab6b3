#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "studies/configuration.h"
#include "studies/interpret.h"
#include "studies/nearest.h"
#include "studies/study_kinds.h"
#include "studies/study_source.h"

namespace zona::studies {

namespace {

using Schemas = std::vector<const Schema*>;

std::vector<std::string> kinds_of(const Schemas& schemas) {
  std::vector<std::string> kinds;
  for (const Schema* schema : schemas) kinds.push_back(schema->kind());
  return kinds;
}

const Schema* find_schema(const Schemas& schemas, const TomlValue& kind) {
  for (const Schema* schema : schemas) {
    if (kind.type == TomlValue::Type::text && kind.text == schema->kind()) return schema;
  }
  return nullptr;
}

/// The schema that `study = "..."` names; takes that entry out of the source.
const Schema& take_schema(const std::filesystem::path& file, StudySource& source,
                          const Schemas& schemas) {
  const auto is_study = [](const SourcedEntry& entry) { return entry.entry.key == "study"; };
  const auto found = std::find_if(source.entries.begin(), source.entries.end(), is_study);
  const std::string kinds = joined(kinds_of(schemas));
  if (found == source.entries.end()) {
    source.problems.push_back({file.string(), "study",
                               fmt::format("the kind of the study is missing; needs one of {}; "
                                           "begin the file with e.g. study = \"{}\"",
                                           kinds, schemas.front()->kind()),
                               0});
    throw InputError(source.problems);
  }
  const Schema* schema = find_schema(schemas, found->entry.value);
  if (schema == nullptr) {
    const std::string nearest = nearest_name(found->entry.value.text, kinds_of(schemas));
    const std::string guess = nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
    source.problems.push_back({found->where, "study",
                               fmt::format("{} is not a study kind; needs one of {}{}",
                                           printable(found->entry.value.written()), kinds, guess),
                               found->line});
    throw InputError(source.problems);
  }
  source.entries.erase(found);
  return *schema;
}

bool is_section(const Schema& schema, const std::string& name) {
  const auto matches = [&](const Section& section) { return section.name == name; };
  return std::any_of(schema.sections().begin(), schema.sections().end(), matches);
}

std::string unknown_key_message(const Schema& schema, const TomlEntry& entry,
                                const Schemas& schemas) {
  if (is_section(schema, entry.key)) {
    return fmt::format("is a table, not a value; write [{}] and its keys below", entry.key);
  }
  for (const std::string& key : schema.keys()) {
    if (entry.key.rfind(key + ".", 0) == 0) {
      return fmt::format("{} is a value, not a table; write e.g. {} = {}", key, key,
                         schema.find(key)->example());
    }
  }
  const std::string unknown = fmt::format("unknown key of a {} study", schema.kind());
  std::vector<std::string> names = schema.keys();
  if (entry.value.type == TomlValue::Type::table) {
    names.clear();
    for (const Section& section : schema.sections()) names.push_back(section.name);
  }
  const std::string nearest = nearest_name(entry.key, names);
  if (!nearest.empty()) return unknown + "; did you mean " + nearest + "?";
  for (const Schema* other : schemas) {
    if (other->find(entry.key) == nullptr) continue;
    return fmt::format("{}; it belongs to a {} study; remove it", unknown, other->kind());
  }
  return unknown + "; remove it (\"zona help\" lists the keys)";
}

/// Gathers problems and settings; one object per load.
class Resolver {
 public:
  Resolver(const Schema& schema, const std::filesystem::path& file, std::vector<Problem> problems)
      : configuration_(schema, file), problems_(std::move(problems)) {}

  void take(const SourcedEntry& source, const Schemas& schemas);
  void fill_in_defaults();
  void check_files();
  void cross_check();
  /// The configuration, or InputError with everything that was found.
  Configuration result();

 private:
  void complain(const std::string& key, const std::string& message);

  Configuration configuration_;
  std::vector<Problem> problems_;
  std::vector<std::string> given_;
};

void Resolver::take(const SourcedEntry& source, const Schemas& schemas) {
  const TomlEntry& entry = source.entry;
  const Schema& schema = configuration_.schema();
  const Parameter* parameter = schema.find(entry.key);
  if (parameter == nullptr) {
    if (entry.value.type == TomlValue::Type::table && is_section(schema, entry.key)) return;
    problems_.push_back(
        {source.where, entry.key, unknown_key_message(schema, entry, schemas), source.line});
    return;
  }
  given_.push_back(entry.key);
  std::vector<std::string> messages;
  Setting setting = interpret(*parameter, entry.value, messages);
  for (const std::string& message : messages) {
    problems_.push_back({source.where, entry.key, message, source.line});
  }
  if (!messages.empty()) return;
  setting.where = source.where;
  setting.line = source.line;
  configuration_.set(entry.key, std::move(setting));
}

void Resolver::fill_in_defaults() {
  for (const Parameter& parameter : configuration_.schema().parameters()) {
    if (std::find(given_.begin(), given_.end(), parameter.key) != given_.end()) continue;
    if (!parameter.is_required()) {
      configuration_.set(parameter.key, default_setting(parameter));
      continue;
    }
    complain(parameter.key,
             fmt::format("is missing; needs {}; write e.g. {} = {}", parameter.expectation(),
                         parameter.key, parameter.example()));
  }
}

void Resolver::check_files() {
  for (const Parameter& parameter : configuration_.schema().parameters()) {
    if (parameter.kind != Parameter::Kind::file) continue;
    try {
      const std::filesystem::path path = configuration_.path(parameter.key);
      std::error_code failure;
      if (path.empty() || std::filesystem::is_regular_file(path, failure)) continue;
      complain(parameter.key,
               fmt::format("there is no file {}; relative paths start at the study file",
                           printable(path.string(), 400)));
    } catch (const MissingSetting&) {
      continue;  // reported already
    }
  }
}

void Resolver::cross_check() {
  const Complain report = [this](const std::string& key, const std::string& message) {
    complain(key, message);
  };
  for (const CrossCheck& check : configuration_.schema().cross_checks()) {
    try {
      check(configuration_, report);
    } catch (const MissingSetting&) {
      continue;  // the value itself is reported already
    }
  }
}

void Resolver::complain(const std::string& key, const std::string& message) {
  int line = 0;
  try {
    line = configuration_.line_of(key);
  } catch (const MissingSetting&) {
    line = 0;
  }
  problems_.push_back({configuration_.where(key), key, message, line});
}

Configuration Resolver::result() {
  if (problems_.empty()) return configuration_;
  const auto place = [](const Problem& problem) {
    return problem.line > 0 ? problem.line : std::numeric_limits<int>::max();
  };
  std::stable_sort(problems_.begin(), problems_.end(),
                   [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
  throw InputError(problems_);
}

}  // namespace

Configuration load_configuration(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides,
                                 const std::vector<const Schema*>& schemas) {
  StudySource source = read_study_source(file, overrides);
  const Schema& schema = take_schema(file, source, schemas);
  Resolver resolver(schema, file, source.problems);
  for (const SourcedEntry& entry : source.entries) resolver.take(entry, schemas);
  resolver.fill_in_defaults();
  resolver.check_files();
  resolver.cross_check();
  return resolver.result();
}

Configuration load_configuration(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides) {
  std::vector<const Schema*> schemas;
  for (const StudyKind& kind : study_kinds()) schemas.push_back(kind.schema);
  return load_configuration(file, overrides, schemas);
}

}  // namespace zona::studies
