#include "studies/study_kinds.h"

#include <stdexcept>

#include "studies/material_point_study.h"
#include "studies/piercing_study.h"
#include "studies/scene_study.h"
#include "studies/search_study.h"
#include "studies/vibration_study.h"

namespace zona::studies {

const std::vector<StudyKind>& study_kinds() {
  static const Schema vibration = make_vibration_schema();
  static const Schema piercing = make_piercing_schema();
  static const Schema comparison = make_comparison_schema();
  static const Schema search = make_search_schema();
  static const Schema scene = make_scene_schema();
  static const Schema material_point = make_material_point_schema();
  static const std::vector<StudyKind> kinds = {
      {&vibration, prepare_vibration, estimate_vibration, try_vibration},
      {&piercing, prepare_piercing, estimate_piercing, try_piercing},
      {&comparison, prepare_comparison, estimate_comparison, try_comparison},
      {&search, prepare_search, estimate_search, try_search},
      {&scene, prepare_scene, estimate_scene, try_scene},
      {&material_point, prepare_material_point, estimate_material_point, {}},
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
