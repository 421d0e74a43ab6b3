#include "studies/verification/evaluation/figure.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace zona::studies::verification {

namespace {

std::string word(Style style) {
  switch (style) {
    case Style::line:
      return "line";
    case Style::points:
      return "points";
    case Style::reference:
      return "reference";
    case Style::limit:
      return "limit";
  }
  throw std::logic_error("unreachable");
}

nlohmann::json to_json(const Axis& axis) {
  return {{"label", axis.label}, {"logarithmic", axis.logarithmic}};
}

nlohmann::json to_json(const Panel& panel) {
  nlohmann::json curves = nlohmann::json::array();
  for (const Curve& curve : panel.curves) {
    curves.push_back(
        {{"label", curve.label}, {"x", curve.x}, {"y", curve.y}, {"style", word(curve.style)}});
  }
  return {
      {"title", panel.title}, {"x", to_json(panel.x)}, {"y", to_json(panel.y)}, {"curves", curves}};
}

}  // namespace

std::vector<std::string> Figure::files(const std::string& case_name) const {
  const std::string stem = case_name + "_" + name;
  if (zona.empty()) return {stem + ".svg"};
  std::vector<std::string> files;
  for (const Zona& picture : zona) files.push_back(stem + "_" + picture.run + ".png");
  return files;
}

nlohmann::json to_json(const Figure& figure) {
  nlohmann::json panels = nlohmann::json::array();
  for (const Panel& panel : figure.panels) panels.push_back(to_json(panel));
  nlohmann::json zona = nlohmann::json::array();
  for (const Figure::Zona& picture : figure.zona) {
    zona.push_back({{"run", picture.run}, {"microseconds", picture.microseconds}});
  }
  return {{"name", figure.name}, {"caption", figure.caption}, {"panels", panels}, {"zona", zona}};
}

}  // namespace zona::studies::verification
