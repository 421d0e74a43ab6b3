#include "studies/program/bundled_studies.h"

#include <algorithm>
#include <fstream>

namespace zona::studies {

namespace fs = std::filesystem;

namespace {

fs::path resource(const std::string& name, const fs::path& in_source) {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  const fs::path installed = program.parent_path().parent_path() / "share" / "zona" / name;
  return !failure && fs::is_directory(installed, failure) ? installed : in_source;
}

std::string first_comment(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const std::size_t text = line.find_first_not_of("# ");
  const bool is_comment = !line.empty() && line.front() == '#' && text != std::string::npos;
  return is_comment ? line.substr(text) : "";
}

}  // namespace

fs::path study_directory() {
  return resource("studies", ZONA_STUDY_DIRECTORY);
}

fs::path report_directory() {
  return resource("report", ZONA_STUDY_DIRECTORY "/report");
}

std::vector<BundledStudy> bundled_studies() {
  std::vector<BundledStudy> studies;
  for (const fs::path& directory : {study_directory(), study_directory() / "verification"}) {
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, failure)) {
      if (entry.path().extension() != ".toml") continue;
      studies.push_back({entry.path(), first_comment(entry.path())});
    }
  }
  std::sort(studies.begin(), studies.end(),
            [](const BundledStudy& a, const BundledStudy& b) { return a.file < b.file; });
  return studies;
}

}  // namespace zona::studies
