#include "studies/kinds/material_point/path_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "studies/kinds/material_point/material_table.h"

namespace zona::studies {

namespace {

using mpm::SymmetricTensor;

constexpr std::array<std::vector<double> StrainPath::*, 6> kStrains{
    &StrainPath::xx, &StrainPath::yy, &StrainPath::zz,
    &StrainPath::xy, &StrainPath::yz, &StrainPath::zx};

bool contains(const std::vector<int>& components, int component) {
  return std::find(components.begin(), components.end(), component) != components.end();
}

bool is_membrane(const Configuration& study) {
  return study.value(&PointMaterial::geometry) == PointGeometry::membrane;
}

/// The strains and free components; like `value`, throws MissingSetting.
StrainPath valid_path(const Configuration& study) {
  StrainPath path{};
  for (const auto strain : kStrains) path.*strain = study.value(strain);
  path.free = study.value(&StrainPath::free);
  return path;
}

void check_components(const Configuration& study, const Complain& complain) {
  const bool membrane = is_membrane(study);
  const std::string free_key = study.key(&StrainPath::free);
  const auto free = study.value(&StrainPath::free);
  for (const auto& [name, component] : kStrainComponents) {
    const auto strain = kStrains[static_cast<std::size_t>(component)];
    const auto values = study.value(strain);
    const bool is_free = contains(free, component);
    const bool is_driven =
        std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
    if (membrane && !contains(kPlaneComponents, component) && (is_free || is_driven)) {
      complain(is_free ? free_key : study.key(strain),
               fmt::format("a membrane is in plane stress: it has no component {} to set; remove "
                           "it, or choose geometry = \"solid\"",
                           name));
    } else if (is_free && is_driven) {
      complain(
          study.key(strain),
          fmt::format("is given although {} is free; remove it here or from {}", name, free_key));
    }
  }
}

void check_stretches(const Configuration& study, const Complain& complain) {
  if (!is_membrane(study)) return;
  for (const auto& e : valid_path(study).targets()) {
    if ((1 + e[0]) * (1 + e[1]) > e[3] * e[3]) continue;
    complain(study.key(&StrainPath::xy),
             fmt::format("a shear of {:g} with the stretches {:g} and {:g} turns the "
                         "membrane inside out; needs a smaller one",
                         e[3], 1 + e[0], 1 + e[1]));
    return;
  }
}

}  // namespace

mpm::FreeComponents StrainPath::free_components() const {
  mpm::FreeComponents result{};
  for (const int component : free) result[static_cast<std::size_t>(component)] = true;
  return result;
}

std::vector<SymmetricTensor> StrainPath::targets() const {
  std::size_t segments = 0;
  for (const auto strain : kStrains) segments = std::max(segments, (this->*strain).size());
  const auto is_free = free_components();
  std::vector<SymmetricTensor> targets(segments);
  for (std::size_t s = 0; s < segments; ++s) {
    for (std::size_t c = 0; c < kStrains.size(); ++c) {
      const std::vector<double>& list = this->*kStrains[c];
      targets[s][c] = is_free[c] ? 0 : list[std::min(s, list.size() - 1)];
    }
  }
  return targets;
}

void declare_path(Schema& schema) {
  TableKeys<StrainPath> keys(schema, "path",
                             "Strain path of the point, from zero. Each list holds the strain "
                             "at the end of each segment; a shorter list stays at its last value.");
  for (const auto& [name, component] : kStrainComponents) {
    keys.numbers(name, kStrains[static_cast<std::size_t>(component)], {0})
        .in("(-1, 1e3]")
        .doc(name[0] == name[1]
                 ? fmt::format("Normal strain {}; a stretch less one for a membrane.", name)
                 : fmt::format("Shear strain {}, the tensor component, half of the angle.", name));
  }
  keys.choices("free", &StrainPath::free, kStrainComponents, {})
      .or_none()
      .doc(
          "Components with free strain: their stress stays zero. [\"yy\", "
          "\"zz\"] with the shears at zero is uniaxial stress.");
  keys.integer("steps", &StrainPath::steps, 200).in("[1, 1000000]").doc("Steps of each segment.");
  schema.check(check_components);
  schema.check(check_stretches);
}

}  // namespace zona::studies
