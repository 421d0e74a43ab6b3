#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "studies/input/table_keys.h"

namespace zona::studies {

/// The pipette as a beam, besides its tip (GlassTube).
struct Beam {
  double length;          ///< free length [m]
  double youngs_modulus;  ///< [Pa]
  int elements;
  double rayleigh_alpha;  ///< [1/s]
  double rayleigh_beta;   ///< [s]
  double loss_factor;     ///< tan(delta) [-]
  double loss_frequency;  ///< at which youngs_modulus is the storage modulus [Hz]
  std::optional<double> shoulder_outer_diameter;  ///< at the support [m]; empty: the tip's
  std::optional<double> shoulder_inner_diameter;  ///< [m]; empty: in the tip's ratio
  std::filesystem::path profile;                  ///< of diameters, instead of shoulders; or empty
};

/// Keys of the beam, in a section that is open, with a default number of elements. Complains of
/// shoulders together with a profile.
void declare_beam(Schema& schema, const std::string& section, long elements);

}  // namespace zona::studies
