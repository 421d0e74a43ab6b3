#include "studies/kinds/study_kinds.h"

#include <stdexcept>

#include "studies/kinds/comparison/schema.h"
#include "studies/kinds/material_point/schema.h"
#include "studies/kinds/material_point/study.h"
#include "studies/kinds/piercing/schema.h"
#include "studies/kinds/piercing/study.h"
#include "studies/kinds/scene/schema.h"
#include "studies/kinds/scene/study.h"
#include "studies/kinds/search/schema.h"
#include "studies/kinds/search/study.h"
#include "studies/kinds/vibration/schema.h"
#include "studies/kinds/vibration/study.h"

namespace zona::studies {

const std::vector<StudyKind>& study_kinds() {
  static const std::vector<StudyKind> kinds = {
      {&vibration_schema(), prepare_vibration, estimate_vibration, try_vibration},
      {&piercing_schema(), prepare_piercing, estimate_piercing, try_piercing},
      {&comparison_schema(), prepare_comparison, estimate_comparison, try_comparison},
      {&search_schema(), prepare_search, estimate_search, try_search},
      {&scene_schema(), prepare_scene, estimate_scene, try_scene},
      {&material_point_schema(), prepare_material_point, estimate_material_point, {}},
  };
  return kinds;
}

const StudyKind& find_study_kind(const std::string& name) {
  for (const StudyKind& kind : study_kinds()) {
    if (kind.schema->kind() == name) return kind;
  }
  throw std::logic_error("there is no study kind " + name);
}

Configuration load_configuration(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides) {
  std::vector<const Schema*> schemas;
  for (const StudyKind& kind : study_kinds()) schemas.push_back(kind.schema);
  return load_configuration(file, overrides, schemas);
}

}  // namespace zona::studies
