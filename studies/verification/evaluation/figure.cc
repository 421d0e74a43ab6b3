#include "studies/verification/evaluation/figure.h"

#include <nlohmann/json.hpp>

namespace zona::studies::verification {

// Found by nlohmann::json, also for the elements of a std::vector.

static void to_json(nlohmann::json& json, const Axis& axis) {
  json = {{"label", axis.label}, {"logarithmic", axis.logarithmic}};
}

static void to_json(nlohmann::json& json, const Curve& curve) {
  constexpr const char* styles[] = {"line", "points", "reference", "limit"};
  const char* style = styles[static_cast<int>(curve.style)];
  json = {{"label", curve.label}, {"x", curve.x}, {"y", curve.y}, {"style", style}};
}

static void to_json(nlohmann::json& json, const Panel& panel) {
  json = {{"title", panel.title}, {"x", panel.x}, {"y", panel.y}, {"curves", panel.curves}};
}

static void to_json(nlohmann::json& json, const Figure::Zona& picture) {
  json = {{"run", picture.run}, {"microseconds", picture.microseconds}};
}

std::vector<std::string> Figure::files(const std::string& case_name) const {
  const std::string stem = case_name + "_" + name;
  if (zona.empty()) return {stem + ".svg"};
  std::vector<std::string> files;
  for (const Zona& picture : zona) files.push_back(stem + "_" + picture.run + ".png");
  return files;
}

nlohmann::json to_json(const Figure& figure) {
  return {{"name", figure.name},
          {"caption", figure.caption},
          {"panels", figure.panels},
          {"zona", figure.zona}};
}

}  // namespace zona::studies::verification
