#include "studies/kinds/scene/measures.h"

#include "studies/kinds/scene/body_table.h"
#include "studies/kinds/scene/time_table.h"
#include "studies/measures/measured_bodies.h"

namespace zona::studies {

namespace {

Substance substance_of(const Configuration& study, const std::string& name) {
  const auto body = body_of_name(study, name);
  if (!body) throw MissingSetting("there is no such body, which is reported elsewhere");
  const MaterialName material = body->value(&SceneBody::material);
  if (!body->applies(&SceneBody::law)) return {material, {}};
  return {material, body->value(&SceneBody::law)};
}

Parameter& declare_probed(Schema& schema, const std::string& key) {
  return schema.reference(key, body_list(schema)).doc("The probed body.");
}

Parameter& declare_averaged(Schema& schema, const std::string& key) {
  return schema.references(key, body_list(schema))
      .auto_by_default()
      .doc("Bodies whose points are averaged together; \"auto\" takes all that are not rigid.");
}

double end_of(const Configuration& study) {
  return study.value(&SceneTime::end);
}

}  // namespace

void declare_scene_measures(Schema& schema) {
  declare_measures(schema, {"", declare_probed, declare_averaged, substance_of, end_of});
}

}  // namespace zona::studies
