#pragma once

#include <optional>

#include "mpm/grid/background_grid.h"
#include "mpm/materials/fluid.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// Choices of the scheme, besides those of mpm::Numerics.
struct Scheme {
  mpm::Interpolation interpolation;
  bool average_volume_strain;  ///< of the fluids
  mpm::EnergyIncrement energy_increment;
};

/// The faces of the domain, all alike.
struct Boundary {
  mpm::FaceCondition kind;
};

struct PiercingTime {
  std::optional<double> end;  ///< [s]; empty: as long as the motion
};

/// The section [numerics].
void declare_scheme(Schema& schema);
/// The sections [time], [boundary], [output] and [run]. Complains of steps and ramps that do not
/// fit.
void declare_piercing_run(Schema& schema);

/// End of the simulation [s]: the given one, or one period of a sine, the duration of a triangle,
/// the window of a beam or a trace, which must lie within the history.
double simulation_end(const Configuration& study);

}  // namespace zona::studies
