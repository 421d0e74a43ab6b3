#include "studies/measures/profile_table.h"

#include "studies/parameters/axes.h"

namespace zona::studies {

namespace {

void check_width(const Table& profile, const Complain& complain) {
  check_box<ProfileTable>(profile, complain, false);
  if (!profile.value(&ProfileTable::width) || profile.value(&ProfileTable::cells) == 1) return;
  complain(profile.leaf(&ProfileTable::cells),
           "counts only where width = \"auto\"; remove one of them");
}

}  // namespace

void declare_profiles(Schema& schema, const MeasuredBodies& bodies) {
  schema.list("profile",
              "Averages over slices along an axis, at chosen times, in profiles.csv: density, "
              "velocity, stress, pressure and energy." +
                  bodies.note,
              0, true);
  TableKeys<ProfileTable> keys(schema, "profile");
  declare_averaged_bodies(keys, bodies);
  keys.choice("axis", &ProfileTable::axis, kAxisNames)
      .doc("The axis that the slices stand across.");
  keys.quantity("width", &ProfileTable::width, "m", "auto")
      .in("(0, 1e6]")
      .or_auto()
      .doc("Thickness of a slice; \"auto\" is `cells` cells. Slices start at `low`.");
  keys.integer("cells", &ProfileTable::cells, 1)
      .in("[1, 1000000]")
      .doc("Cells that an \"auto\" slice is thick.");
  declare_box(keys, "Only points in this box count.");
  keys.choice("membership", &ProfileTable::membership, kMemberships)
      .doc(
          "Whether a slice holds the points that started in it, wherever they are, as in the "
          "source's averages of points initialised in a cell; or those that are in it now.");
  declare_average_times(keys);
  schema.check_each(keys.section(), [=](const Table& profile, const Complain& complain) {
    check_averages<ProfileTable>(profile, complain, bodies);
  });
  schema.check_each(keys.section(), check_width);
}

}  // namespace zona::studies
