#include "studies/program/python_script.h"

#include <array>
#include <cstdio>

namespace zona::studies {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

ScriptOutcome run_script(const std::filesystem::path& script,
                         const std::vector<std::filesystem::path>& arguments) {
  std::string line = "/usr/bin/python3 -B " + quoted(script.string());
  for (const auto& argument : arguments) line += " " + quoted(argument.string());
  std::FILE* pipe = popen((line + " 2>&1").c_str(), "r");
  if (!pipe) return {false, "/usr/bin/python3 cannot be started"};
  std::string output;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe)) output += buffer.data();
  return {pclose(pipe) == 0, output};
}

std::string end_of(const std::string& output) {
  constexpr std::size_t shown = 600;
  return output.size() > shown ? "..." + output.substr(output.size() - shown) : output;
}

}  // namespace zona::studies
