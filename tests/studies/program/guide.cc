#include <catch2/catch.hpp>

#include "studies/kinds/study_kinds.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;

namespace {

/// The whole studies among the TOML examples of a page.
std::vector<std::string> studies_on(const std::string& page) {
  const std::string text = read_text(std::string(ZONA_SOURCE_DIR "/") + page);
  std::vector<std::string> studies;
  const std::string fence = "```toml\n";
  for (std::size_t at = 0; (at = text.find(fence, at)) != std::string::npos;) {
    at += fence.size();
    const std::string example = text.substr(at, text.find("```", at) - at);
    const bool is_whole = example.find("study = ") != std::string::npos ||
                          example.find("base = ") != std::string::npos;
    if (is_whole) studies.push_back(example);
  }
  return studies;
}

}  // namespace

TEST_CASE("the studies printed in the README, the guide and the tutorials are valid") {
  std::size_t count = 0;
  std::vector<std::string> pages{"README.md", "docs/guide.md"};
  for (const auto& entry : std::filesystem::directory_iterator(ZONA_SOURCE_DIR "/docs/tutorials")) {
    pages.push_back("docs/tutorials/" + entry.path().filename().string());
  }
  for (const std::string& page : pages) {
    for (const std::string& text : studies_on(page)) {
      const ScratchDirectory scratch;  // as it were the clone, where bases are found
      std::filesystem::create_directory_symlink(ZONA_SOURCE_DIR "/studies",
                                                scratch.path() / "studies");
      const Configuration study = load_configuration(scratch.write("s.toml", text));
      CHECK_NOTHROW(find_study_kind(study.kind()).prepare(study));
      ++count;
    }
  }
  CHECK(count >= 6);
}

TEST_CASE("every study file of the verification can be prepared") {
  const std::filesystem::path directory(ZONA_SOURCE_DIR "/studies/verification");
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path().string());
    const Configuration study = load_configuration(entry.path());
    CHECK_NOTHROW(find_study_kind(study.kind()).prepare(study));
    ++count;
  }
  CHECK(count >= 12);
}
