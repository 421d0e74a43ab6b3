#include "studies/kinds/search/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace zona::studies::search {

const std::vector<Measure>& measures() {
  using Of = Measure::Of;
  static const std::vector<Measure> all = {
      {"mismatch", Of::tip, "", 1, "", "mismatch",
       "Root mean square of the difference between the tip's motion and that of the reference, "
       "over that of the reference, in the window of the piercing."},
      {"residual_motion", Of::tip, "m", 1e6, "um", "residual motion",
       "Greatest displacement of the tip after the window of the piercing."},
      {"tip_amplitude", Of::tip, "m", 1e6, "um", "tip amplitude",
       "Greatest displacement of the tip."},
      {"tip_travel", Of::tip, "m", 1e6, "um", "tip in window",
       "Greatest displacement of the tip from where it is at the window's start, in the window of "
       "the piercing."},
      {"peak_velocity", Of::tip, "m/s", 1, "m/s", "tip speed", "Greatest speed of the tip."},
      {"support_peak", Of::tip, "m", 1e6, "um", "support peak",
       "Greatest displacement of the support: what the drive must provide."},
      {"failed_area", Of::oocyte, "m^2", 1e12, "um^2", "failed area",
       "Undeformed area of the zona that failed."},
      {"hole_over_pipette", Of::oocyte, "", 1, "", "hole/pipette",
       "Diameter of a round hole of the failed area over that of the pipette."},
      {"largest_strain_away", Of::oocyte, "", 1, "", "strain away",
       "Greatest strain of the zona further than a pipette's diameter from hole and contact."},
      {"largest_displacement_away", Of::oocyte, "m", 1e6, "um", "deformation",
       "Greatest displacement of the zona further than a pipette's diameter from hole and "
       "contact."},
      {"deepest_indentation", Of::oocyte, "m", 1e6, "um", "indentation",
       "Greatest indentation of the intact zona by the pipette."},
      {"highest_cytoplasm_pressure", Of::oocyte, "Pa", 1e-3, "kPa", "pressure",
       "Highest pressure in the cytoplasm, cell by cell."},
      {"highest_cytoplasm_shear_rate", Of::oocyte, "1/s", 1e-3, "1/ms", "shear rate",
       "Highest shear rate in the cytoplasm, cell by cell."},
      {"pipette_work", Of::oocyte, "J", 1e12, "pJ", "work", "Work of the pipette."},
      {"path_after_failure", Of::oocyte, "m", 1e6, "um", "path after failure",
       "Path of the tip in the window after the zona began to fail."},
  };
  return all;
}

const Measure& find_measure(const std::string& name) {
  const auto found = std::find_if(measures().begin(), measures().end(),
                                  [&](const Measure& measure) { return measure.name == name; });
  if (found == measures().end()) throw std::logic_error("there is no measure " + name);
  return *found;
}

Words<const Measure*> measure_words() {
  Words<const Measure*> words;
  for (const Measure& measure : measures()) words.push_back({measure.name.c_str(), &measure});
  return words;
}

Words<const Measure*> measure_words(Measure::Of of) {
  Words<const Measure*> words;
  for (const Measure& measure : measures())
    if (measure.of == of) words.push_back({measure.name.c_str(), &measure});
  return words;
}

std::vector<std::string> measure_names(Measure::Of of) {
  std::vector<std::string> names;
  for (const Measure& measure : measures())
    if (measure.of == of) names.push_back(measure.name);
  return names;
}

std::string shown_number(const Measure& measure, double value) {
  const double shown = value * measure.shown_factor;
  return std::abs(shown) < 1000 ? fmt::format("{:.3g}", shown) : fmt::format("{:.0f}", shown);
}

std::string shown(const Measure& measure, double value) {
  const std::string number = shown_number(measure, value);
  return measure.shown_unit.empty() ? number : number + " " + measure.shown_unit;
}

}  // namespace zona::studies::search
