#include <fmt/format.h>

#include <algorithm>

#include "studies/input/configuration.h"
#include "studies/input/nearest.h"
#include "studies/input/resolver.h"

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
    source.problems.push_back(
        {found->where, "study",
         fmt::format("{} is not a study kind{}; needs one of {}{}",
                     printable(found->entry.value.written()),
                     schemas.size() == 1 ? " that can be used here" : "", kinds, guess),
         found->line});
    throw InputError(source.problems);
  }
  source.entries.erase(found);
  return *schema;
}

}  // namespace

Configuration load_configuration(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides,
                                 const std::vector<const Schema*>& schemas) {
  StudySource source = read_study_source(file, overrides);
  const Schema& schema = take_schema(file, source, schemas);
  Resolver resolver(schema, file, source);
  for (const SourcedEntry& entry : source.entries) resolver.take(entry, schemas);
  resolver.complete();
  resolver.check_names();
  resolver.check_files();
  resolver.cross_check();
  return resolver.result();
}

}  // namespace zona::studies
