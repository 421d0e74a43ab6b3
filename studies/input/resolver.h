#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/input/source_items.h"

namespace zona::studies {

/// Turns a source into a configuration and collects all its problems. Use one object per load and
/// call the members in this order.
class Resolver {
 public:
  Resolver(const Schema& schema, const std::filesystem::path& file, const StudySource& source);

  /// Checks and stores the value of an entry. `schemas`: the kinds that an unknown key may belong
  /// to.
  void take(const SourcedEntry& source, const std::vector<const Schema*>& schemas);
  /// Adds defaults and reports keys that do not apply.
  void complete();
  /// Checks that names are unique and that what is referred to exists.
  void check_names();
  void check_files();
  void cross_check();
  /// Returns the configuration. Throws InputError with all problems in the order of the file.
  Configuration result();

 private:
  enum class Applies { yes, no, unknown };

  void report_unknown(const SourcedEntry& source, const std::vector<const Schema*>& schemas);
  bool is_inherited(const std::string& key) const;
  Applies applies(const Parameter& parameter, const std::string& table) const;
  void complete(const Parameter& parameter, const std::string& table);
  void check_distinct(const std::string& list);
  void check_reference(const std::string& key, const Parameter& parameter);
  void complain(const std::string& key, const std::string& message);

  Configuration configuration_;
  std::vector<Problem> problems_;
  std::set<std::string> given_;
  std::set<std::string> reported_tables_;
};

}  // namespace zona::studies
