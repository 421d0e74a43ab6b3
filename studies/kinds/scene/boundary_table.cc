#include "studies/kinds/scene/boundary_table.h"

#include "studies/parameters/face_conditions.h"

namespace zona::studies {

void declare_scene_boundary(Schema& schema) {
  TableKeys<SceneBoundary> keys(schema, "boundary", "The six faces of the grid.");
  const auto face = [&](const char* leaf, mpm::FaceCondition SceneBoundary::*member) {
    keys.choice(leaf, member, kFaceConditions)
        .doc(
            "Free (a point that leaves the grid ends the run), no motion through the face, no "
            "motion at all, or viscous stresses that absorb outgoing waves (5.43)-(5.50).");
  };
  face("x_low", &SceneBoundary::x_low);
  face("x_high", &SceneBoundary::x_high);
  face("y_low", &SceneBoundary::y_low);
  face("y_high", &SceneBoundary::y_high);
  face("z_low", &SceneBoundary::z_low);
  face("z_high", &SceneBoundary::z_high);
}

}  // namespace zona::studies
