#include "studies/kinds/scene/motion_table.h"

namespace zona::studies {

namespace {

const Words<mpm::Drive> kDrives{{"points", mpm::Drive::points}, {"nodes", mpm::Drive::nodes}};

}  // namespace

void declare_body_motion(Schema& schema, const std::string& section, const Condition& deforms,
                         const Condition& is_rigid) {
  TableKeys<BodyMotion> keys(schema, section);
  keys.formulas("velocity", &BodyMotion::velocity, "m/s", {"x", "y", "z"}, {"0", "0", "0"})
      .exactly(3)
      .in("[-1e9, 1e9]")
      .only_where(deforms)
      .doc("Initial velocity.");
  keys.formulas("displacement", &BodyMotion::displacement, "m", {"t"}, {"0", "0", "0"})
      .exactly(3)
      .in("[-1e6, 1e6]")
      .only_where(is_rigid)
      .doc("Displacement from the initial place; 0 for a body that is fixed.");
  keys.choice("drive", &BodyMotion::drive, kDrives)
      .only_where(is_rigid)
      .doc(
          "Where the motion is prescribed: at the body's points, which the grid mixes with their "
          "surroundings by mass, or at every node that they touch, which is harsher but does not "
          "yield.");
}

}  // namespace zona::studies
