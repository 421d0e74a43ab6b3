#include "studies/measure_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "studies/piercing_values.h"
#include "studies/point_values.h"

namespace zona::studies {

namespace {

const std::vector<std::string> piercing_bodies{"zona", "cytoplasm", "medium", "pipette", "plate"};

bool one_of(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// What a body is made of, as far as it decides what can be measured.
struct Substance {
  std::string material;  ///< "solid", "gas", "liquid", "membrane" or "rigid"
  std::string law;       ///< of a solid or membrane, else empty

  bool has(const std::string& quantity) const {
    if (one_of(quantity, {"position", "displacement", "velocity"})) return true;
    if (quantity == "strain") return material == "membrane";
    if (quantity == "damage") return one_of(law, {"elastodamage", "decohesion"});
    if (quantity == "plastic_strain") return one_of(law, {"von_mises", "decohesion"});
    return material != "rigid";
  }
};

Substance substance_in_scene(const Configuration& study, const std::string& name) {
  for (const Table& body : study.items("body")) {
    if (body.name() != name) continue;
    return {body.choice("material"), body.applies("law") ? body.choice("law") : ""};
  }
  throw MissingSetting("body");  // there is no such body, which is reported elsewhere
}

Substance substance_in_piercing(const Configuration& study, const std::string& name) {
  if (name == "zona") return {"membrane", study.choice("zona.law")};
  return {name == "cytoplasm" || name == "medium" ? "liquid" : "rigid", ""};
}

using FindSubstance = Substance (*)(const Configuration&, const std::string&);

void check_probe(const Table& probe, const Complain& complain, FindSubstance find) {
  check_box(probe, complain, false);
  const std::string& name = probe.text("body");
  const Substance substance = find(probe.study(), name);
  for (const std::string& quantity : probe.texts("quantities")) {
    if (substance.has(quantity)) continue;
    const std::string law = substance.law.empty() ? "" : ", law " + substance.law;
    complain("quantities", fmt::format("the points of {} (material {}{}) have no {}; leave it out",
                                       name, substance.material, law, quantity));
  }
}

void check_averaged(const Table& table, const Complain& complain, double end, FindSubstance find) {
  if (!table.is_auto("times")) {
    for (const double time : table.quantities("times")) {
      if (time <= end) continue;
      complain("times", fmt::format("{:g} s is after the end of the run, {:g} s", time, end));
    }
  }
  if (table.is_auto("bodies")) return;
  for (const std::string& name : table.texts("bodies")) {
    if (find(table.study(), name).material != "rigid") continue;
    complain("bodies", fmt::format("{} is rigid: it has no stress to average", name));
  }
}

void check_width(const Table& profile, const Complain& complain) {
  check_box(profile, complain, false);
  if (profile.is_auto("width") || profile.integer("cells") == 1) return;
  complain("cells", "counts only where width = \"auto\"; remove one of them");
}

void declare_probe(Schema& schema) {
  schema.choice("probe.kind", {"point", "mean"})
      .doc("The point that starts nearest to a place, or the mean over the points in a box.");
  schema.quantities("probe.place", "m", {})
      .without_default()
      .exactly(3)
      .in("[-1e6, 1e6]")
      .only_with("kind", {"point"})
      .doc("The place; the summary says which point it is, and how far.");
  declare_box(schema, "probe", "The box of the points.", {{"kind", {"mean"}}});
  schema.choice("probe.membership", {"initial", "current"})
      .only_with("kind", {"mean"})
      .doc("Whether points belong that were in the box at the start, or that are in it now.");
  schema.choices("probe.quantities", quantity_names(), {"displacement", "velocity"})
      .doc(
          "What is followed. Stress, pressure, density, strain and damage are averaged by volume, "
          "all else by mass. The strain is the largest principal one of a membrane; the energy is "
          "specific, internal of a fluid, elastic of a solid or membrane.");
}

void declare_times(Schema& schema, const std::string& list) {
  schema.quantities(list + ".times", "s", {})
      .in("[0, 1e6]")
      .auto_by_default()
      .doc("When; the step that is nearest counts. \"auto\" is the end.");
}

void declare_profile(Schema& schema) {
  schema.choice("profile.axis", {"x", "y", "z"}).doc("The axis that the slices stand across.");
  schema.quantity("profile.width", "m", "auto")
      .in("(0, 1e6]")
      .or_auto()
      .doc("Thickness of a slice; \"auto\" is `cells` cells. Slices start at `low`.");
  schema.integer("profile.cells", 1)
      .in("[1, 1000000]")
      .doc("Cells that an \"auto\" slice is thick.");
  declare_box(schema, "profile", "Only points in this box count.");
  schema.choice("profile.membership", {"initial", "current"})
      .doc(
          "Whether a slice holds the points that started in it, wherever they are, as in the "
          "source's averages of points initialised in a cell; or those that are in it now.");
  declare_times(schema, "profile");
}

void declare_section(Schema& schema) {
  schema.choice("section.normal", {"z", "x", "y"}).doc("The axis that the plane stands across.");
  schema.quantity("section.place", "m", "")
      .without_default()
      .in("[-1e6, 1e6]")
      .doc("Where the plane cuts that axis. Points in the layer of cells around it count.");
  declare_times(schema, "section");
}

const char* const probe_text =
    "What is followed in history.csv, a column a component: a point, or the mean of several.";
const char* const profile_text =
    "Averages over slices along an axis, at chosen times, in profiles.csv: density, velocity, "
    "stress, pressure and energy.";
const char* const section_text =
    "Averages over the cells that a plane cuts, at chosen times, in sections.csv: as of profiles.";
const char* const from_egg = " Places count from the middle of the egg.";

}  // namespace

void declare_box(Schema& schema, const std::string& section, const std::string& documentation,
                 const std::vector<Condition>& conditions) {
  const double far = std::numeric_limits<double>::infinity();
  const auto corner = [&](const char* name, double end, const std::string& sentences) {
    Parameter& parameter = schema.quantities(section + "." + name, "m", {"grid", "grid", "grid"})
                               .exactly(3)
                               .in("[-1e6, 1e6]")
                               .or_named({{"grid", end}})
                               .doc(sentences);
    parameter.conditions = conditions;
  };
  corner("low", -far, documentation + " Lower corner; \"grid\" reaches as far as the grid does.");
  corner("high", far, "Upper corner of that box.");
}

void check_box(const Table& table, const Complain& complain, bool may_be_flat) {
  if (!table.applies("low")) return;
  const auto low = table.quantities("low"), high = table.quantities("high");
  for (int axis = 0; axis < 3; ++axis) {
    if (low[axis] < high[axis] || (may_be_flat && low[axis] == high[axis])) continue;
    complain("high", fmt::format("{} = {:g} m is not above low, {:g} m", "xyz"[axis], high[axis],
                                 low[axis]));
  }
}

void declare_scene_measures(Schema& schema) {
  schema.list("probe", probe_text, 0, true);
  schema.reference("probe.body", "body").doc("The body that is probed.");
  declare_probe(schema);
  for (const auto& [list, text] : {std::pair{"profile", profile_text}, {"section", section_text}}) {
    schema.list(list, text, 0, true);
    schema.references(std::string(list) + ".bodies", "body")
        .auto_by_default()
        .doc("Bodies whose points are averaged together; \"auto\" takes all that are not rigid.");
    list == std::string("profile") ? declare_profile(schema) : declare_section(schema);
    schema.check_each(list, [](const Table& table, const Complain& complain) {
      check_averaged(table, complain, table.study().quantity("time.end"), substance_in_scene);
    });
  }
  schema.check_each("profile", check_width);
  schema.check_each("probe", [](const Table& probe, const Complain& complain) {
    check_probe(probe, complain, substance_in_scene);
  });
}

void declare_piercing_measures(Schema& schema) {
  schema.list("probe", probe_text + std::string(from_egg), 0, true);
  schema.choice("probe.body", piercing_bodies).doc("The body that is probed.");
  declare_probe(schema);
  for (const auto& [list, text] : {std::pair{"profile", profile_text}, {"section", section_text}}) {
    schema.list(list, text + std::string(from_egg), 0, true);
    schema
        .choices(std::string(list) + ".bodies", {"zona", "cytoplasm", "medium"},
                 {"cytoplasm", "medium"})
        .doc("Bodies whose points are averaged together.");
    list == std::string("profile") ? declare_profile(schema) : declare_section(schema);
    schema.check_each(list, [](const Table& table, const Complain& complain) {
      check_averaged(table, complain, simulation_end(table.study()), substance_in_piercing);
    });
  }
  schema.check_each("profile", check_width);
  schema.check_each("probe", [](const Table& probe, const Complain& complain) {
    check_probe(probe, complain, substance_in_piercing);
    if (probe.text("body") == "plate" && !probe.study().boolean("plate.enabled")) {
      complain("body", "there is no plate: plate.enabled = false");
    }
  });
}

}  // namespace zona::studies
