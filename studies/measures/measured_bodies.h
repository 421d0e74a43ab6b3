#pragma once

#include <functional>
#include <optional>
#include <string>

#include "studies/input/configuration.h"
#include "studies/measures/point_values.h"
#include "studies/parameters/material_words.h"

namespace zona::studies {

/// The material of a body, as far as it decides what can be measured.
struct Substance {
  MaterialName material;
  std::optional<LawName> law;  ///< of a solid or membrane

  /// Whether its points have a quantity that belongs to these.
  bool has(PointQuantity::Of of) const;
  /// "material membrane, law elastic".
  std::string text() const;
};

/// What [[probe]], [[profile]] and [[section]] need to know of a study kind.
struct MeasuredBodies {
  std::string note;  ///< appended to the documentation of the lists
  /// Declares a key for the body of a probe, as a text.
  std::function<Parameter&(Schema&, const std::string& key)> declare_probed;
  /// Declares a key for bodies averaged together, as texts or "auto".
  std::function<Parameter&(Schema&, const std::string& key)> declare_averaged;
  /// What the body of that name is made of. Throws MissingSetting if there is no such body.
  std::function<Substance(const Configuration&, const std::string& name)> substance;
  std::function<double(const Configuration&)> end;  ///< of the run [s]
};

/// Declares the lists [[probe]], [[profile]] and [[section]].
void declare_measures(Schema& schema, const MeasuredBodies& bodies);

}  // namespace zona::studies
