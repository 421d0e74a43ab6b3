#include "studies/kinds/scene/measures.h"

#include "studies/measures/measure_parameters.h"

namespace zona::studies {

namespace {

Substance substance_of(const Configuration& study, const std::string& name) {
  for (const Table& body : study.items("body")) {
    if (body.name() != name) continue;
    return {body.choice("material"), body.applies("law") ? body.choice("law") : ""};
  }
  throw MissingSetting("body");  // there is no such body, which is reported elsewhere
}

void declare_probed(Schema& schema, const std::string& key) {
  schema.reference(key, "body").doc("The body that is probed.");
}

void declare_averaged(Schema& schema, const std::string& key) {
  schema.references(key, "body")
      .auto_by_default()
      .doc("Bodies whose points are averaged together; \"auto\" takes all that are not rigid.");
}

double end_of(const Configuration& study) {
  return study.quantity("time.end");
}

}  // namespace

void declare_scene_measures(Schema& schema) {
  declare_measures(schema, {"", declare_probed, declare_averaged, substance_of, end_of});
}

}  // namespace zona::studies
