#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/parameters/box.h"

namespace zona::studies {

enum class LoadKind { force, traction, pressure };

/// A [[load]] on a body; formulas are of time, and only those of its kind are there. A force or
/// traction acts on the points that lie in a box at the start.
struct Load : BoxKeys {
  LoadKind kind;
  std::string body;
  std::vector<Formula> force;       ///< x, y, z of the total [N]
  std::vector<Formula> traction;    ///< x, y, z [Pa]
  double area;                      ///< that the traction acts on [m^2]
  std::optional<Formula> pressure;  ///< on a membrane, positive outwards [Pa]
};

/// The list [[load]], after [[body]]. Complains of loads that a body cannot take.
void declare_loads(Schema& schema);

}  // namespace zona::studies
