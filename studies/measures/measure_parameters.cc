#include "studies/measures/measure_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "studies/measures/point_values.h"
#include "studies/parameters/box.h"

namespace zona::studies {

namespace {

bool one_of(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

using FindSubstance = decltype(MeasuredBodies::substance);

void check_probe(const Table& probe, const Complain& complain, const FindSubstance& find) {
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

void check_averaged(const Table& table, const Complain& complain, double end,
                    const FindSubstance& find) {
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
}  // namespace

bool Substance::has(const std::string& quantity) const {
  if (one_of(quantity, {"position", "displacement", "velocity"})) return true;
  if (quantity == "strain") return material == "membrane";
  if (quantity == "damage") return one_of(law, {"elastodamage", "decohesion"});
  if (quantity == "plastic_strain") return one_of(law, {"von_mises", "decohesion"});
  return material != "rigid";
}

void declare_measures(Schema& schema, const MeasuredBodies& bodies) {
  schema.list("probe", probe_text + bodies.note, 0, true);
  bodies.declare_probed(schema, "probe.body");
  declare_probe(schema);
  schema.check_each("probe", [=](const Table& probe, const Complain& complain) {
    check_probe(probe, complain, bodies.substance);
  });
  const auto declare_averages = [&](const char* list, const std::string& text) {
    schema.list(list, text + bodies.note, 0, true);
    bodies.declare_averaged(schema, std::string(list) + ".bodies");
    schema.check_each(list, [=](const Table& table, const Complain& complain) {
      check_averaged(table, complain, bodies.end(table.study()), bodies.substance);
    });
  };
  declare_averages("profile", profile_text);
  declare_profile(schema);
  schema.check_each("profile", check_width);
  declare_averages("section", section_text);
  declare_section(schema);
}

}  // namespace zona::studies
