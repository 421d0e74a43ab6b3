#pragma once

#include <functional>
#include <string>

#include "studies/input/configuration.h"
#include "studies/input/schema.h"

namespace zona::studies {

/// The material of a body, as far as it decides what can be measured.
struct Substance {
  std::string material;  ///< "solid", "gas", "liquid", "membrane" or "rigid"
  std::string law;       ///< of a solid or membrane, else empty

  /// Whether its points have this quantity (point_quantities).
  bool has(const std::string& quantity) const;
};

/// What [[probe]], [[profile]] and [[section]] need to know of a study kind.
struct MeasuredBodies {
  std::string note;  ///< appended to the documentation of the lists
  std::function<void(Schema&, const std::string& key)> declare_probed;  ///< the body of a probe
  std::function<void(Schema&, const std::string& key)>
      declare_averaged;  ///< bodies averaged together
  /// What the body of that name is made of. Throws MissingSetting if there is no such body.
  std::function<Substance(const Configuration&, const std::string& name)> substance;
  std::function<double(const Configuration&)> end;  ///< of the run [s]
};

/// Declares the lists [[probe]], [[profile]] and [[section]].
void declare_measures(Schema& schema, const MeasuredBodies& bodies);

}  // namespace zona::studies
