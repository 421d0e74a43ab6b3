#pragma once

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <string>

namespace zona::studies::testing {

/// What a call of the program came to.
struct Answer {
  int code;
  std::string text;  ///< both streams
};

/// Runs the program as a user would.
inline Answer call(const std::string& arguments) {
  const std::string command = ZONA_PROGRAM " " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  Answer answer;
  for (int character; (character = fgetc(pipe)) != EOF;)
    answer.text += static_cast<char>(character);
  answer.code = WEXITSTATUS(pclose(pipe));
  return answer;
}

}  // namespace zona::studies::testing
