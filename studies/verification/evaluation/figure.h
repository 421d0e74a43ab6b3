#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace zona::studies::verification {

enum class Style {
  line,       ///< computed
  points,     ///< computed, one mark per value
  reference,  ///< exact or independent: a dark line
  limit       ///< of what is allowed: a thin dashed line
};

struct Curve {
  std::string label = {};  ///< empty: not in the legend
  std::vector<double> x = {}, y = {};
  Style style = Style::line;

  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

struct Axis {
  std::string label;  ///< with its unit: "time [us]"
  bool logarithmic = false;
};

struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Curve> curves = {};
};

/// Panels side by side, or the zona of a run as `render_zona.py` draws it.
struct Figure {
  std::string name;  ///< of its file, without extension; unique in its case
  std::string caption;
  std::vector<Panel> panels = {};
  struct Zona {
    std::string run;                   ///< label of the run
    std::vector<double> microseconds;  ///< instants
  };
  std::vector<Zona> zona = {};  ///< one picture each, in place of panels

  /// File names of what is drawn, relative to the folder of figures, for a case of this name.
  std::vector<std::string> files(const std::string& case_name) const;
};

nlohmann::json to_json(const Figure& figure);

}  // namespace zona::studies::verification
