#include <fmt/format.h>

#include "tests/studies/kinds/scene/scene_files.h"

using namespace zona::studies::testing;
using Catch::Contains;

namespace {

const std::string small_piercing =
    "study = \"piercing\"\ngrid = {cell = \"12 um\", domain = \"168 um\"}\nzona.level = 4\n"
    "cytoplasm.points_per_cell = 8\ntime.end = \"3 us\"\noutput.fields = false\n";

struct Piercing {
  explicit Piercing(const std::string& rest) {
    answer = call("run " + scratch.write("s.toml", small_piercing + rest).string() +
                  " --quiet --out " + out().string());
    INFO(answer.text);
    REQUIRE(answer.code == 0);
    history = read_columns(out() / "history.csv");
    results = nlohmann::json::parse(read_text(out() / "summary.json"))["results"];
  }
  std::filesystem::path out() const { return scratch.path() / "out"; }

  ScratchDirectory scratch;
  Answer answer;
  std::map<std::string, std::vector<double>> history;
  nlohmann::json results;
};

}  // namespace

TEST_CASE("a section holds the means over the cells that a plane cuts") {
  const Run run(stretched_water + R"toml([[section]]
name = "middle"
normal = "y"
place = "2.3 m"
times = ["0 s"]
)toml");
  const auto section = read_columns(run.out() / "sections.csv");
  REQUIRE(section.at("x").size() == 3 * 4);  // by z, then x
  for (std::size_t i = 0; i < 12; ++i) {
    const double x = 1.05 + 0.1 * static_cast<double>(i % 3);
    const double z = 3.025 + 0.05 * static_cast<double>(i / 3);
    CHECK(section.at("x")[i] == Approx(x));
    CHECK(section.at("y")[i] == Approx(2.3));
    CHECK(section.at("z")[i] == Approx(z));
    CHECK(section.at("points")[i] == 8);
    CHECK(section.at("pressure")[i] == Approx(1e5 * (1 + x + 2 * 2.3)));
    CHECK(section.at("velocity_z")[i] == Approx(-z));
  }
}

TEST_CASE("a piercing has probes, profiles and sections, counted from the middle of the egg") {
  const Piercing run(R"toml(
[[probe]]
name = "tip"
body = "pipette"
place = ["50 um", "4 um", "0 um"]
quantities = ["displacement"]
[[probe]]
name = "pole"
body = "zona"
place = ["50 um", "0 um", "0 um"]
quantities = ["displacement", "strain"]
[[probe]]
name = "core"
kind = "mean"
body = "cytoplasm"
low = ["-10 um", "-10 um", "-10 um"]
high = ["10 um", "10 um", "10 um"]
quantities = ["position", "pressure"]
[[profile]]
name = "axis"
axis = "x"
bodies = ["cytoplasm"]
membership = "current"
[[section]]
name = "plane"
normal = "z"
place = "0 um"
)toml");
  // The tip does what it is told, the egg lies still in the middle of the grid.
  for (std::size_t i = 0; i < run.history.at("time").size(); ++i) {
    CHECK(run.history.at("probe.tip.displacement_y")[i] ==
          Approx(run.history.at("pipette_y")[i]).margin(1e-15));
  }
  CHECK(run.results["probes"]["pole"]["distance"].get<double>() < 4e-6);
  CHECK(run.results["probes"]["pole"]["strain"]["highest"].get<double>() > 0);
  CHECK(run.history.at("probe.core.position_y").front() == Approx(84e-6));
  CHECK(run.history.at("plate_force_x").size() == run.history.at("time").size());
  const auto profile = read_columns(run.out() / "profiles.csv");
  double points = 0;
  for (const double p : profile.at("points")) points += p;
  const auto check = call("check " + (run.scratch.path() / "s.toml").string());
  CHECK_THAT(check.text, Contains(fmt::format("cytoplasm {:.0f}", points)));
  const auto section = read_columns(run.out() / "sections.csv");
  CHECK(section.at("x").size() > 100);
  for (const double z : section.at("z")) CHECK(z == Approx(90e-6));  // the cell above the middle
}

TEST_CASE("a section that does not cut the grid is refused before anything is written") {
  const ScratchDirectory scratch;
  const std::string section = "[[section]]\nname = \"far\"\nnormal = \"y\"\nplace = ";
  const auto check = [&](const std::string& text) {
    return call("check " + scratch.write("s.toml", text).string());
  };
  const Answer far = check(small_piercing + section + "\"85 um\"\n");
  CHECK(far.code == 2);
  CHECK_THAT(far.text,
             Contains("section.far.place: 8.5e-05 m is outside the grid, -8.4e-05 to 8.4e-05 m"));
  CHECK(check(small_piercing + section + "\"84 um\"\n").code == 0);
  CHECK(check("study = \"scene\"\n" + stretched_water + section + "\"1.9 m\"\n").code == 2);
}

TEST_CASE("invalid measures of a piercing are refused") {
  const auto refused = [](const std::string& rest) {
    return problems_of("study = \"piercing\"\n" + rest);
  };
  const std::string probe = "[[probe]]\nname = \"p\"\n";
  const std::string place = "place = [\"0 m\", \"0 m\", \"0 m\"]\n";
  CHECK(refused(probe + place + "body = \"plate\"\nquantities = [\"position\"]").empty());
  CHECK_THAT(refused("plate.enabled = false\n" + probe + place + "body = \"plate\""),
             Contains("probe.p.body: there is no plate"));
  CHECK_THAT(refused(probe + place + "body = \"zna\""), Contains("did you mean \"zona\"?"));
  CHECK_THAT(refused(probe + place + "body = \"medium\"\nquantities = [\"strain\"]"),
             Contains("the points of medium (material liquid) have no strain"));
  CHECK_THAT(refused(probe + "body = \"zona\""), Contains("probe.p.place: is missing"));
  CHECK_THAT(refused("[[section]]\nname = \"s\"\nplace = \"0 m\"\ntimes = [\"1 s\"]"),
             Contains("after the end of the run"));
  CHECK_THAT(refused("[[section]]\nname = \"s\"\nplace = \"0 m\"\nbodies = [\"plate\"]"),
             Contains("section.s.bodies"));
  CHECK_THAT(refused("[[profile]]\nname = \"s\"\nlow = [\"1 m\", \"grid\", \"grid\"]\nhigh = [\"0 "
                     "m\", \"grid\", \"grid\"]"),
             Contains("is not above low"));
}
