#pragma once

#include <optional>

#include "beam/pipette/pipette.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// The liquid around a beam.
struct Bath {
  beam::BathModel model;
  double density;                       ///< [kg/m^3]
  double viscosity;                     ///< [Pa s]
  double immersed_length;               ///< from the tip [m]
  double frequency;                     ///< of BathModel::constant [Hz]
  double drag_coefficient;              ///< of a quadratic drag [-]
  std::optional<double> wall_distance;  ///< from the axis [m]; empty: far away

  beam::Bath bath() const;
};

/// Words of bath.model.
const Words<beam::BathModel>& bath_models();

/// The section [bath].
void declare_bath(Schema& schema);

}  // namespace zona::studies
