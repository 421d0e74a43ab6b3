#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "studies/input/binding.h"

namespace zona::studies::search {

/// A quantity that a search minimises or keeps within limits: one of the tip's motion, which takes
/// a beam, or one of the oocyte, which takes a piercing. Less is better.
struct Measure {
  enum class Of { tip, oocyte };

  std::string name;  ///< in study files and in results
  Of of;
  std::string unit;           ///< SI; empty for a pure number
  double shown_factor;        ///< from SI to what people read
  std::string shown_unit;     ///< "um^2"
  std::string title;          ///< "failed area"
  std::string documentation;  ///< a sentence
};

/// Values of measures by name, in SI.
using Values = std::map<std::string, double>;

const std::vector<Measure>& measures();

/// Throws std::logic_error for an unknown name.
const Measure& find_measure(const std::string& name);

/// Names of the measures of the tip or of the oocyte.
std::vector<std::string> measure_names(Measure::Of of);
/// Words of a study file for all measures, or for those of tip or oocyte.
Words<const Measure*> measure_words();
Words<const Measure*> measure_words(Measure::Of of);

/// The number in the unit that people read, to three digits and never with an exponent above one:
/// "2065", "3.64".
std::string shown_number(const Measure& measure, double value);
/// The same with its unit: "2065 um^2".
std::string shown(const Measure& measure, double value);

}  // namespace zona::studies::search
