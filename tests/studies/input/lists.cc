#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <cmath>

#include "studies/run/resolved_study.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
using Catch::Equals;

namespace {

/// A study kind with all that a list of tables can have.
Schema rooms() {
  Schema schema("house", "Rooms and doors.");
  schema.section("house", "The house.");
  schema.quantities("house.size", "m", {"10 m", "10 m", "3 m"})
      .exactly(3)
      .or_one_for_all()
      .in("(0, 100]");
  schema.list("room", "Rooms.", 1, true);
  schema.choice("room.form", {"box", "dome", "attic"});
  schema.quantity("room.width", "m", "4 m").in("(0, 10]").only_with("form", {"box", "attic"});
  schema.quantity("room.radius", "m", "")
      .without_default()
      .in("(0, 10]")
      .only_with("form", {"dome"});
  schema.choice("room.roof", {"flat", "steep"}).only_with("form", {"attic"});
  schema.quantity("room.pitch", "rad", "45 deg").only_with("roof", {"steep"});
  schema.formulas("room.draught", "m/s", {"x", "y", "z"}, {"0", "0", "0"})
      .exactly(3)
      .in("[-10, 10]");
  schema.choices("room.lamps", {"table", "floor"}, {"table"});
  schema.references("room.next_to", "room").or_none();
  schema.list("door", "Doors.", 0, false);
  schema.reference("door.room", "room");
  schema.quantity("door.width", "m", "0.8 m").in("(0, 5]");
  schema.check_each("door", [](const Table& door, const Complain& complain) {
    if (door.quantity("width") > 4) complain("width", "4 m are wide for a door");
  });
  return schema;
}

Configuration load(const std::string& text, const std::vector<std::string>& overrides = {}) {
  static const Schema schema = rooms();
  const ScratchDirectory scratch;
  return load_configuration(scratch.write("s.toml", "study = \"house\"\n" + text), overrides,
                            {&schema});
}

std::string problems(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    load(text, overrides);
    return "";
  } catch (const InputError& error) {
    std::string message;
    for (const Problem& problem : error.problems()) {
      message += fmt::format("{}{}: {}: {}", message.empty() ? "" : "\n", problem.line, problem.key,
                             problem.message);
    }
    return message;
  }
}

const std::string two_rooms = R"([[room]]
name = "hall"
width = "6 m"
draught = ["0.1 m/s", "x/10", "0"]

[[room]]
name = "cupola"
form = "dome"
radius = "2 m"
next_to = ["hall"]
)";

}  // namespace

TEST_CASE("lists of tables are read item by item, with defaults") {
  const Configuration study = load(two_rooms + "[[door]]\nroom = \"hall\"\n");
  CHECK(study.item_count("room") == 2);
  CHECK(study.tables() == std::vector<std::string>{"house", "room.0", "room.1", "door.0"});
  const std::vector<Table> all = study.items("room");
  CHECK(all[0].name() == "hall");
  CHECK(all[0].quantity("width") == 6);
  CHECK(all[1].quantity("radius") == 2);
  CHECK(all[1].texts("next_to") == std::vector<std::string>{"hall"});
  CHECK(all[0].texts("next_to").empty());
  CHECK(all[0].formulas("draught")[1].at(Eigen::Vector3d(5, 0, 0)) == 0.5);
  CHECK(all[0].texts("lamps") == std::vector<std::string>{"table"});
  CHECK(study.items("door")[0].name() == "0");
  CHECK(study.line_of("room.0.width") == 4);
  CHECK(study.shown_key("room.1.radius") == "room.cupola.radius");
}

TEST_CASE("a key has a value only where it applies") {
  const Configuration study = load(two_rooms);
  CHECK(study.applies("room.0.width"));
  CHECK_FALSE(study.applies("room.0.radius"));
  CHECK_FALSE(study.applies("room.1.width"));
  CHECK_FALSE(study.applies("room.0.pitch"));
  CHECK_THROWS_AS(study.quantity("room.1.width"), MissingSetting);
  CHECK_THAT(problems("[[room]]\nname = \"a\"\nradius = \"1 m\"\n"),
             Equals("4: room.a.radius: applies only where form = \"dome\"; remove it"));
  CHECK_THAT(problems("[[room]]\nname = \"a\"\nform = \"dome\"\nradius = \"1 m\"\nwidth = \"1 m\""),
             Equals("6: room.a.width: applies only where form = \"box\" or \"attic\"; remove it"));
  CHECK_THAT(problems("[[room]]\nname = \"a\"\npitch = \"1 rad\"\n"),
             Equals("4: room.a.pitch: applies only where roof = \"steep\"; remove it"));
  CHECK(
      load("[[room]]\nname = \"a\"\nform = \"attic\"\nroof = \"steep\"").quantity("room.0.pitch") ==
      Approx(M_PI / 4));
  // A choice that is itself wrong is the only problem.
  CHECK_THAT(problems("[[room]]\nname = \"a\"\nform = \"dom\"\nradius = \"1 m\"\n"),
             Equals("4: room.a.form: \"dom\" is not known here; needs one of box, dome or attic; "
                    "did you mean \"dome\"?"));
}

TEST_CASE("one value stands for a list where that is allowed") {
  CHECK(load(two_rooms + "[house]\nsize = \"2 m\"\n").quantities("house.size") ==
        std::vector<double>{2, 2, 2});
  CHECK(load(two_rooms).quantities("house.size") == std::vector<double>{10, 10, 3});
  CHECK_THAT(problems(two_rooms + "[house]\nsize = [\"2 m\", \"3 m\"]\n"),
             Contains("the list has 2 items") && Contains("one alone stands for all"));
  CHECK_THAT(problems(two_rooms + "[house]\nsize = \"200 m\"\n"), Contains("out of range"));
}

TEST_CASE("all problems of all items are reported together, by line and name") {
  CHECK_THAT(problems(R"([[room]]
name = "hall"
widht = "6 m"
draught = ["1", "q", "20 m/s"]
lamps = ["tabel"]

[[room]]
form = "dome"

[[room]]
name = "hall"

[[door]]
room = "hal"
width = "4.5 m"
)"),
             Equals("4: room.hall.widht: unknown key of a house study; did you mean width?\n"
                    "5: room.hall.draught: \"1\" has no unit; needs a unit of velocity, e.g. \"0.1 "
                    "m/s\", or a formula of x, y and z in SI\n"
                    "5: room.hall.draught: \"q\" is neither a quantity nor a formula: Unexpected "
                    "token \"q\" found at character 1; needs e.g. \"0.1 m/s\", or a formula of x, "
                    "y and z in SI\n"
                    "5: room.hall.draught: \"20 m/s\" is out of range; needs a list of 3, each a "
                    "velocity or a formula of x, y and z in SI, at least -10 m/s and at most 10 "
                    "m/s; write e.g. draught = [\"0\", \"0\", \"0\"]\n"
                    "6: room.hall.lamps: \"tabel\" is not known here; needs a list, each one of "
                    "table or floor; did you mean \"table\"?\n"
                    "8: room.1.name: is missing; needs a name of letters, digits, _ and -; write "
                    "e.g. name = \"left\"\n"
                    "8: room.1.radius: is missing; needs a length, above 0 m and at most 10 m; "
                    "write e.g. radius = \"6 um\"\n"
                    "12: room.hall.name: there is a room \"hall\" already; choose another name\n"
                    "15: door.0.room: there is no room \"hal\"; did you mean \"hall\"?\n"
                    "16: door.0.width: 4 m are wide for a door"));
}

TEST_CASE("a table in place of a list, or a list in place of a table, is reported") {
  CHECK_THAT(problems(""), Contains("room: is missing; needs at least 1; write [[room]]"));
  CHECK_THAT(problems("[room]\nname = \"a\"\nwidth = \"1 m\"\n" + two_rooms.substr(0, 0)),
             Contains("2: room") || Contains("3: room"));
  CHECK_THAT(problems("[room]\nname = \"a\"\n"), Contains("is a list of tables; write [[room]]"));
  CHECK_THAT(problems("room = 3\n"), Contains("is a list of tables; write [[room]]"));
  CHECK_THAT(problems(two_rooms + "[[house]]\nsize = \"1 m\"\n"),
             Equals("12: house: is a table, not a list of tables; write [house]"));
  CHECK_THAT(problems(two_rooms + "[[windw]]\nroom = \"hall\"\nwidth = \"1 m\"\n"),
             Equals("12: windw: unknown key of a house study; remove it (\"zona help\" lists the "
                    "keys)"));
  CHECK_THAT(problems(two_rooms + "[[dor]]\nroom = \"hall\"\n"), Contains("did you mean door?"));
  CHECK_THAT(problems("[[room]]\nname = \"a\"\n[room.form]\nkind = \"box\"\n"),
             Contains("room.form is a value, not a table"));
  CHECK(problems("room = [{name = \"a\"}, {name = \"b\", form = \"attic\"}]\ndoor = []\n").empty());
}

TEST_CASE("names are words") {
  const auto named = [](const std::string& name) {
    return problems("[[room]]\nname = \"" + name + "\"\n");
  };
  CHECK(named("left_2-b").empty());
  CHECK_THAT(named("my room"), Contains("\"my room\" is not a name; needs at most 40 letters"));
  CHECK_THAT(named("12"), Contains("no mere number"));
  CHECK_THAT(named(""), Contains("is not a name"));
  CHECK_THAT(named("a.b"), Contains("is not a name"));
}

TEST_CASE("overrides reach items by name or by number") {
  CHECK(load(two_rooms, {"room.hall.width=\"5 m\""}).quantity("room.0.width") == 5);
  CHECK(load(two_rooms, {"room.1.radius=\"3 m\""}).quantity("room.1.radius") == 3);
  CHECK(load(two_rooms, {"room.hall.lamps=[\"floor\"]"}).texts("room.0.lamps").front() == "floor");
  CHECK_THAT(problems(two_rooms, {"room.hal.width=\"5 m\""}),
             Equals("0: room.hal.width: there is no room \"hal\" among the 2; did you "
                    "mean room.hall?"));
  CHECK_THAT(problems(two_rooms, {"room.2.width=\"5 m\""}),
             Contains("there is no room \"2\" among the 2"));
  CHECK_THAT(problems(two_rooms, {"room.hall.widht=\"5 m\""}), Contains("did you mean width?"));
  CHECK_THAT(problems(two_rooms, {"room.hall.width=\"5 m\"", "room.0.width=\"4 m\""}),
             Contains("is set twice"));
  const std::string with_door = two_rooms + "[[door]]\nroom = \"hall\"\n";
  CHECK(load(with_door).item_count("door") == 1);
  CHECK(load(with_door, {"door=[]"}).item_count("door") == 0);
  const Configuration more =
      load(with_door, {"door=[{room = \"hall\"}, {name = \"back\", room = \"cupola\"}]"});
  CHECK(more.item_count("door") == 2);
  CHECK(more.items("door")[1].text("room") == "cupola");
}

TEST_CASE("a resolved study with lists loads to the same values") {
  const Configuration study =
      load(two_rooms + "[[door]]\nname = \"front\"\nroom = \"hall\"\n[house]\nsize = \"9 m\"\n");
  const std::string text = resolved_study(study);
  CHECK_THAT(text, Contains("[[room]]\nname = \"hall\"\n") && Contains("[[door]]\n"));
  const Configuration again = load(text.substr(text.find('\n', text.find("study =")) + 1));
  CHECK(again.tables() == study.tables());
  for (const std::string& table : study.tables()) {
    REQUIRE(again.keys_of(table) == study.keys_of(table));
    for (const std::string& key : study.keys_of(table)) {
      INFO(key);
      CHECK(again.setting(key).numbers == study.setting(key).numbers);
      CHECK(again.setting(key).texts == study.setting(key).texts);
    }
  }
  CHECK_THAT(si_table(study), Contains("room.hall.draught    [0.1, \"x/10\", 0] m/s"));
  CHECK_THAT(si_table(study), Contains("house.size"));
}
