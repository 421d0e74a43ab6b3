#include "coupling/tip_trace.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "coupling/slopes.h"
#include "mpm/files/atomic_file.h"
#include "mpm/files/hdf5_file.h"
#include "tests/scratch_directory.h"

using namespace zona::coupling;
using Catch::Contains;
using Catch::Matchers::WithinRel;
using zona::beam::TipHistory;
using zona::tests::ScratchDirectory;

namespace {

TipHistory random_history(std::size_t samples) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  TipHistory history;
  double time = -1e-6;
  for (std::size_t i = 0; i < samples; ++i) {
    history.time.push_back(time += 1e-6 * (1.5 + uniform(random)));
    history.displacement.push_back(1e-5 * uniform(random));
    history.velocity.push_back(uniform(random));
    history.acceleration.push_back(1e5 * uniform(random));
    history.support.push_back(std::exp(40 * uniform(random)));
  }
  history.support.front() = std::numeric_limits<double>::denorm_min();
  history.support.back() = -0.0;
  return history;
}

void check_same(const TipHistory& left, const TipHistory& right) {
  CHECK(left.time == right.time);
  CHECK(left.displacement == right.displacement);
  CHECK(left.velocity == right.velocity);
  CHECK(left.acceleration == right.acceleration);
  CHECK(left.support == right.support);
  CHECK(std::signbit(left.support.back()) == std::signbit(right.support.back()));
}

}  // namespace

TEST_CASE("a trace survives CSV and HDF5 to the last bit", "[trace]") {
  const ScratchDirectory scratch;
  const TipHistory history = random_history(100);
  for (const char* name : {"tip.csv", "tip.h5", "tip.hdf5"}) {
    INFO(name);
    const std::string path = scratch / name;
    for (int twice = 0; twice < 2; ++twice)  // the second write replaces the first
      std::filesystem::path(path).extension() == ".csv" ? write_tip_trace_csv(history, path)
                                                        : write_tip_trace_hdf5(history, path);
    check_same(read_tip_trace(path), history);
    CHECK_FALSE(std::filesystem::exists(path + ".tmp"));
  }
}

TEST_CASE("the headings of a trace have units, also with Greek letters", "[trace]") {
  const TipHistory history = parse_tip_trace_csv(
      "velocity [mm/s],time [\xC2\xB5s],displacement[ \xCE\xBCm ],support [mm],"
      "acceleration [um/us\xC2\xB2]\n"
      "1,0,17.9,1,2\n2e3,0.6,-.5,2,3\n3,1.2,25e-2,3,4\n",
      "trace.csv");
  CHECK(history.time == std::vector<double>{0, 0.6e-6, 1.2e-6});
  CHECK(history.displacement == std::vector<double>{17.9 / 1e6, -0.5 / 1e6, 0.25 / 1e6});
  CHECK(history.velocity == std::vector<double>{1e-3, 2, 3e-3});
  CHECK(history.acceleration == std::vector<double>{2e6, 3e6, 4e6});
  CHECK(history.support == std::vector<double>{1e-3, 2e-3, 3e-3});
}

TEST_CASE("a measured trace of displacements alone is completed", "[trace]") {
  // Displacement t^2 um at uneven times in ms: velocity 2 t mm/s, exact for a parabola.
  const TipHistory history =
      parse_tip_trace_csv("time [ms],displacement [um]\n0,0\n1,1\n3,9\n4,16\n7,49\n", "trace.csv");
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    CHECK(history.velocity[i] == Approx(2 * history.time[i]).margin(1e-15));
    CHECK_THAT(history.acceleration[i], WithinRel(2.0, 1e-12));
    CHECK(history.support[i] == 0);
  }
}

TEST_CASE("second-order slopes converge with order two", "[trace]") {
  const auto error = [](int intervals) {
    std::vector<double> time, value;
    for (int i = 0; i <= intervals; ++i) {
      const double x = static_cast<double>(i) / intervals;
      time.push_back(x + 0.1 * x * x);
      value.push_back(std::sin(5 * time.back()));
    }
    const std::vector<double> slope = second_order_slopes(time, value);
    double largest = 0;
    for (std::size_t i = 0; i < time.size(); ++i)
      largest = std::max(largest, std::abs(slope[i] - 5 * std::cos(5 * time[i])));
    return largest;
  };
  CHECK(std::log2(error(200) / error(400)) == Approx(2).margin(0.05));
}

TEST_CASE("a malformed CSV trace is refused with file, line and column", "[trace]") {
  const std::string head = "time [s],displacement [m]\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {head, "t.csv: no values under the headings"},
      {head + "0,0\n1,1\n", "t.csv: 2 samples; at least 3"},
      {head + "0,0\n1,nan\n2,2\n", "t.csv:3:3: 'nan' is not finite"},
      {head + "0,0\n1,1\n1,2\n", "t.csv:4:1: time 1 s is not after the previous time, 1 s"},
      {head + "0,0\n\n#\n1,1\n0.5,2\n", "t.csv:6:1: time 0.5 s is not after"},
      {"time [s],displacment [m]\n",
       "t.csv:1:10: unknown heading 'displacment'; known are: time, displacement, velocity, "
       "acceleration, support"},
      {"time,displacement [m]\n", "t.csv:1:1: 'time' lacks its unit; write for example 'time [s]'"},
      {"time [],displacement [m]\n", "t.csv:1:6: unknown unit '' of time"},
      {"time [h],displacement [m]\n",
       "t.csv:1:6: unknown unit 'h' of time; known are: s, ms, us, ns"},
      {"time [s],displacement [s]\n", "t.csv:1:23: unknown unit 's' of displacement"},
      {"time [s],velocity [m/s]\n", "t.csv:1:1: no column 'displacement [m]'"},
      {"displacement [m]\n", "t.csv:1:1: no column 'time [s]'"},
      {"acceleration [um/us^2],time [s],displacement [m]\n1e305,0,0\n",
       "t.csv:2:1: '1e305' is out of range"},
  };
  for (const auto& [text, message] : cases) {
    INFO(text);
    CHECK_THROWS_WITH(parse_tip_trace_csv(text, "t.csv"), Contains(message));
    CHECK_THROWS_AS(parse_tip_trace_csv(text, "t.csv"), TraceError);
  }
}

TEST_CASE("no damaged CSV text does worse than a TraceError", "[trace]") {
  const std::string good =
      "time [us],displacement [um],velocity [m/s]\n0,0,1\n0.6,1.25e-3,2\n1.2,3,4\n1.8,5,-6\n";
  const std::string letters = "0123456789.,-+eE[]#\n\r\t x\xC2\xB5";
  std::mt19937 random(11);
  const auto below = [&](std::size_t limit) { return random() % limit; };
  std::size_t accepted = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text = good;
    for (std::size_t damage = 0; damage <= below(4); ++damage) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text[at] = letters[below(letters.size())];
          break;
        case 1:
          text.erase(at, 1 + below(5));
          break;
        case 2:
          text.insert(at, 1, letters[below(letters.size())]);
          break;
        default:
          text[at] = static_cast<char>(below(256));
          break;
      }
      if (text.empty()) break;
    }
    try {
      check_tip_history(parse_tip_trace_csv(text, "fuzz.csv"), "fuzz.csv");
      ++accepted;
    } catch (const TraceError&) {
    }
  }
  CHECK(accepted > 0);
}

TEST_CASE("files that cannot be read or written are named", "[trace]") {
  const ScratchDirectory scratch;
  CHECK_THROWS_WITH(read_tip_trace(scratch / "none.csv"), Contains("none.csv: cannot open"));
  CHECK_THROWS_AS(read_tip_trace(scratch / "none.h5"), zona::mpm::Hdf5Error);
  const TipHistory history = random_history(4);
  CHECK_THROWS_AS(write_tip_trace_csv(history, "/no/such/folder/tip.csv"), zona::mpm::FileError);
  CHECK_THROWS_AS(write_tip_trace_hdf5(history, "/no/such/folder/tip.h5"), zona::mpm::FileError);
}

TEST_CASE("an inconsistent history is neither written nor read from HDF5", "[trace]") {
  const ScratchDirectory scratch;
  TipHistory history = random_history(4);
  history.velocity[2] = std::nan("");
  CHECK_THROWS_WITH(write_tip_trace_csv(history, scratch / "tip.csv"),
                    Contains("velocity of sample 2 is nan"));
  history = random_history(4);
  history.support.pop_back();
  CHECK_THROWS_WITH(write_tip_trace_hdf5(history, scratch / "tip.h5"),
                    Contains("3 values of support at 4 times"));
  CHECK(std::filesystem::is_empty(scratch.path()));

  const std::string path = scratch / "bad.h5";
  zona::mpm::Hdf5File file = zona::mpm::Hdf5File::create(path);
  file.write("/time", std::vector<double>{0, 2, 1});
  CHECK_THROWS_WITH(read_tip_trace(path), Contains("/displacement"));
  file.write("/displacement", std::vector<double>{0, 1, 2});
  CHECK_THROWS_WITH(read_tip_trace(path), Contains("time of sample 2 is 1 s, not after 2 s"));
}
