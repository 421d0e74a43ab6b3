#pragma once

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <string>

namespace zona::studies::testing {

/// What a command came to.
struct Answer {
  int code;
  std::string text;  ///< both streams
};

/// Runs a command line of the shell.
inline Answer run_command(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  Answer answer;
  for (int character; (character = fgetc(pipe)) != EOF;)
    answer.text += static_cast<char>(character);
  answer.code = WEXITSTATUS(pclose(pipe));
  return answer;
}

/// Runs the program as a user would.
inline Answer call(const std::string& arguments) {
  return run_command(ZONA_PROGRAM " " + arguments);
}

inline bool has_program(const std::string& name) {
  return run_command("command -v " + name).code == 0;
}

}  // namespace zona::studies::testing
