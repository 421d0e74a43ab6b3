#include "studies/input/run_isolated.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace zona::studies {

namespace {

/// Signals end this process in the default way, without a core file, and an alarm after `seconds`.
void reset_signals(unsigned seconds) {
  const rlimit nothing{0, 0};
  setrlimit(RLIMIT_CORE, &nothing);
  for (const int number : {SIGALRM, SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) {
    std::signal(number, SIG_DFL);
  }
  sigset_t alarm_only;
  sigemptyset(&alarm_only);
  sigaddset(&alarm_only, SIGALRM);
  sigprocmask(SIG_UNBLOCK, &alarm_only, nullptr);
  alarm(seconds);
}

[[noreturn]] void work_and_exit(const std::function<void()>& work, unsigned seconds) {
  reset_signals(seconds);
  try {
    work();
  } catch (...) {
  }
  _exit(0);  // runs no exit handlers, which belong to the parent process
}

}  // namespace

std::string run_isolated(const std::function<void()>& work, unsigned seconds) {
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "no further process");
  if (child == 0) work_and_exit(work, seconds);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "lost a process");
  }
  if (WIFSIGNALED(status)) {
    if (WTERMSIG(status) == SIGALRM) return "no end within " + std::to_string(seconds) + " s";
    return strsignal(WTERMSIG(status));
  }
  return WEXITSTATUS(status) == 0 ? "" : "exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace zona::studies
