#include "studies/measures/measured_bodies.h"

#include "studies/measures/probe_table.h"
#include "studies/measures/profile_table.h"
#include "studies/measures/section_table.h"

namespace zona::studies {

bool Substance::has(PointQuantity::Of of) const {
  using Of = PointQuantity::Of;
  switch (of) {
    case Of::all:
      return true;
    case Of::deformable:
      return material != MaterialName::rigid;
    case Of::membranes:
      return material == MaterialName::membrane;
    case Of::failing:
      return law == LawName::elastodamage || law == LawName::decohesion;
    case Of::plastic:
      return law == LawName::von_mises || law == LawName::decohesion;
  }
  return false;
}

std::string Substance::text() const {
  const std::string text = "material " + word_for(kMaterialNames, material);
  return law ? text + ", law " + word_for(kLawNames, *law) : text;
}

void declare_measures(Schema& schema, const MeasuredBodies& bodies) {
  declare_probes(schema, bodies);
  declare_profiles(schema, bodies);
  declare_sections(schema, bodies);
}

}  // namespace zona::studies
