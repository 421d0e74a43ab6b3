#include "studies/input/run_isolated.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>

using zona::studies::run_isolated;

TEST_CASE("isolated work leaves this process unchanged") {
  int count = 0;
  CHECK(run_isolated([&] { ++count; }).empty());
  CHECK(run_isolated([] { throw std::runtime_error("refused"); }).empty());
  CHECK(count == 0);
}

TEST_CASE("run_isolated returns what ended the work early") {
  CHECK(run_isolated([] { raise(SIGSEGV); }) == "Segmentation fault");
  CHECK(run_isolated([] { raise(SIGKILL); }) == "Killed");
  CHECK(run_isolated([] { _exit(3); }) == "exit code 3");
  CHECK(run_isolated(
            [] {
              for (;;) pause();
            },
            1) == "no end within 1 s");
}
