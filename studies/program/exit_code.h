#pragma once

#include <functional>

namespace zona::studies {

/// Exit codes of the program; scripts of users rely on these numbers.
enum ExitCode {
  exit_ok = 0,
  exit_bad_input = 2,
  exit_failed = 3,
  exit_not_verified = 4,
  exit_interrupted = 130
};

/// Calls `command` and turns what it throws into messages on the error stream and an exit code.
int with_messages(const std::function<int()>& command);

}  // namespace zona::studies
