#include "studies/input/rehearsal.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>

using zona::studies::rehearse;

TEST_CASE("work that comes to its end passes the rehearsal, and changes nothing here") {
  int count = 0;
  CHECK(rehearse([&] { ++count; }).empty());
  CHECK(rehearse([] { throw std::runtime_error("refused"); }).empty());
  CHECK(count == 0);
}

TEST_CASE("a rehearsal tells what ended the work") {
  CHECK(rehearse([] { raise(SIGSEGV); }) == "Segmentation fault");
  CHECK(rehearse([] { raise(SIGKILL); }) == "Killed");
  CHECK(rehearse([] { _exit(3); }) == "exit code 3");
  CHECK(rehearse(
            [] {
              for (;;) pause();
            },
            1) == "no end within 1 s");
}
