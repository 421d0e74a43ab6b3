#include "mpm/files/read_file.h"

#include <catch2/catch.hpp>
#include <string>

#include "tests/scratch_directory.h"

using zona::mpm::read_file;

TEST_CASE("a whole file is read, byte by byte") {
  const zona::tests::ScratchDirectory scratch;
  const std::string content = std::string("a\0b\r\n", 5) + std::string(100000, 'x');
  CHECK(read_file(scratch.write("full", content).string()) == content);
  CHECK(read_file(scratch.write("empty", "").string()) == "");
  CHECK_FALSE(read_file((scratch.path() / "none").string()));
  CHECK_FALSE(read_file(scratch.path().string()));
}
