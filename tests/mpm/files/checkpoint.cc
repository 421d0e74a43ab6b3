#include "mpm/files/checkpoint.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

// Inline functions only: the tests do not link the library.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "mpm/files/atomic_file.h"
#include "tests/scratch_directory.h"

using namespace zona::mpm;
using zona::tests::ScratchDirectory;

namespace {

struct State {
  std::vector<double> reals{0.1, -0.0, 1e-310};
  std::vector<std::int32_t> numbers{3, 1, 2};
  std::int64_t steps = std::int64_t{1} << 40;

  VisitState visit() {
    return [this](StateVisitor& visitor) {
      visitor.visit("reals", reals);
      visitor.visit("body/numbers", numbers);
      visitor.visit("steps", steps);
    };
  }
  bool operator==(const State& o) const {
    return reals == o.reals && numbers == o.numbers && steps == o.steps;
  }
};

std::string content(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The end of a checkpoint.
std::string end_of(const std::string& image) {
  const XXH64_hash_t hash = XXH3_64bits(image.data(), image.size());
  return "ZONAHASH" + std::string(reinterpret_cast<const char*>(&hash), sizeof hash);
}

}  // namespace

TEST_CASE("a checkpoint restores its state and its labels", "[checkpoint]") {
  const ScratchDirectory scratch;
  State state;
  write_checkpoint(scratch / "a", {{"version", "1"}, {"study", ""}}, state.visit());
  State other{{0, 0, 0}, {0, 0, 0}, 0};
  const Checkpoint checkpoint(scratch / "a");
  CHECK(checkpoint.labels() == CheckpointLabels{{"version", "1"}, {"study", ""}});
  checkpoint.restore(other.visit());
  CHECK(other == state);
  CHECK(std::signbit(other.reals[1]));
  CHECK_FALSE(std::filesystem::exists(scratch / "a.tmp"));
}

TEST_CASE("any damage to a checkpoint is detected", "[checkpoint]") {
  const ScratchDirectory scratch;
  const std::string path = scratch / "a";
  write_checkpoint(path, {}, State().visit());
  const std::string whole = content(path);
  std::mt19937 random(7);
  for (int trial = 0; trial < 500; ++trial) {
    std::string damaged = whole;
    damaged[random() % whole.size()] ^= static_cast<char>(1 << random() % 8);
    write(path, damaged);
    CHECK_THROWS_WITH(Checkpoint(path), Catch::Contains(path + ": is damaged"));
  }
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{15}, whole.size() / 2, whole.size() - 1}) {
    write(path, whole.substr(0, size));
    CHECK_THROWS_AS(Checkpoint(path), CheckpointError);
  }
  CHECK_THROWS_AS(Checkpoint(scratch / "none"), CheckpointError);
  CHECK_THROWS_AS(Checkpoint(scratch.path()), CheckpointError);
}

TEST_CASE("a file with a valid hash but without a state is refused", "[checkpoint]") {
  const ScratchDirectory scratch;
  const std::string path = scratch / "a";
  for (const std::string image : {"", "plain text", "\x89HDF\r\n\x1a\n"}) {
    write(path, image + end_of(image));
    CHECK_THROWS_AS(Checkpoint(path), CheckpointError);
  }
  write_checkpoint(path, {{"version", "1"}}, State().visit());
  const std::string whole = content(path);
  const std::string image = whole.substr(0, whole.size() - end_of("").size());
  REQUIRE(end_of(image) == whole.substr(image.size()));
  for (std::size_t size = 8; size + 64 < image.size(); size += 97) {
    const std::string part = image.substr(0, size);
    write(path, part + end_of(part));
    State state;
    CHECK_THROWS_AS(Checkpoint(path).restore(state.visit()), CheckpointError);
  }
}

TEST_CASE("a checkpoint of another model is refused", "[checkpoint]") {
  const ScratchDirectory scratch;
  write_checkpoint(scratch / "a", {}, State().visit());
  State larger;
  larger.reals.push_back(1);
  CHECK_THROWS_WITH(Checkpoint(scratch / "a").restore(larger.visit()),
                    Catch::Contains("reals has 3 values, but the model needs 4"));
  double unknown = 0;
  CHECK_THROWS_WITH(
      Checkpoint(scratch / "a").restore([&](StateVisitor& v) { v.visit("unknown", unknown); }),
      Catch::Contains("unknown") && Catch::Contains("belongs to another model"));
}

TEST_CASE("a failed write keeps the old checkpoint", "[checkpoint]") {
  CHECK_THROWS_WITH(write_checkpoint("/proc/none/a", {}, State().visit()),
                    Catch::Contains("/proc/none/a: cannot be written (No such file"));
  const ScratchDirectory scratch;
  write_checkpoint(scratch / "a", {}, State().visit());
  std::filesystem::create_directory(scratch / "a.tmp");
  CHECK_THROWS_AS(write_checkpoint(scratch / "a", {}, State().visit()), FileError);
  CHECK_NOTHROW(Checkpoint(scratch / "a"));
}
