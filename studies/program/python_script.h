#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace zona::studies {

/// What a Python script came to.
struct ScriptOutcome {
  bool succeeded;
  std::string output;  ///< both streams
};

/// Runs a script with the system's Python, which has the packages that it needs.
ScriptOutcome run_script(const std::filesystem::path& script,
                         const std::vector<std::filesystem::path>& arguments);

/// The last few hundred characters of an output, where the reason of a failure stands.
std::string end_of(const std::string& output);

}  // namespace zona::studies
