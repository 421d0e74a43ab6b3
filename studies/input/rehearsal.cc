#include "studies/input/rehearsal.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace zona::studies {

namespace {

/// Leaves no core behind, and lets signals end this process as they end any.
void prepare_to_die(unsigned seconds) {
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
  prepare_to_die(seconds);
  try {
    work();
  } catch (...) {
  }
  _exit(0);  // nothing that the other process has begun is ended here
}

}  // namespace

std::string rehearse(const std::function<void()>& work, unsigned seconds) {
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
