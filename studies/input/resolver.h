#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/input/source_items.h"

namespace zona::studies {

/// Makes a configuration of what a source holds, and gathers everything that is wrong with it; one
/// object per load, its members called in this order.
class Resolver {
 public:
  Resolver(const Schema& schema, const std::filesystem::path& file, const StudySource& source);

  /// Checks and takes the value of an entry. `schemas` are those it may belong to instead.
  void take(const SourcedEntry& source, const std::vector<const Schema*>& schemas);
  /// Defaults of what was not given, and which of what was given does not apply.
  void complete();
  /// Names are used once, references name something, files exist.
  void check_names();
  void check_files();
  void cross_check();
  /// The configuration, or InputError with everything that was found, in the order of the file.
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
