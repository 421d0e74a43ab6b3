#include "studies/program/list_studies.h"

#include <fmt/format.h>

#include <filesystem>

#include "studies/kinds/study_kinds.h"
#include "studies/program/bundled_studies.h"
#include "studies/program/exit_code.h"

namespace zona::studies {

namespace {

std::string shorter_path(const std::filesystem::path& path) {
  std::error_code failure;
  const std::string relative = std::filesystem::proximate(path, failure).string();
  return !failure && relative.size() < path.string().size() ? relative : path.string();
}

}  // namespace

int list_studies() {
  fmt::print("Study kinds:\n");
  for (const StudyKind& kind : study_kinds()) {
    fmt::print("  {:<14} {}\n", kind.schema->kind(), kind.schema->summary());
  }
  fmt::print("\nBundled study files:\n");
  for (const BundledStudy& study : bundled_studies()) {
    fmt::print("  {}\n      {}\n", shorter_path(study.file), study.description);
  }
  return exit_ok;
}

}  // namespace zona::studies
