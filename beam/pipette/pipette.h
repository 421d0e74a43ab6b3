#pragma once

#include <vector>

#include "beam/pipette/hydrodynamics.h"
#include "beam/pipette/section.h"

namespace zona::beam {

/// Outer and inner diameter of a pipette at a distance from its tip.
struct Diameters {
  double from_tip = 0;  ///< [m]
  double outer = 0;     ///< [m]
  double inner = 0;     ///< [m]
};

/// A part of the bore that is filled with one fluid.
struct FillColumn {
  double start = 0;                       ///< distance from the tip [m]
  double end = 0;                         ///< [m]
  double density = 0;                     ///< [kg/m^3]
  double viscosity = Liquid{}.viscosity;  ///< as Pipette::fill_viscosity [Pa s]
};

/// Model of the liquid around a pipette.
enum class BathModel {
  none,       ///< no liquid: the pipette vibrates in air, treated as a vacuum
  constant,   ///< added mass and drag of one frequency
  per_mode,   ///< each mode has the added mass and drag of its own frequency; for modal
              ///< superposition
  frequency,  ///< exact added mass and drag at every frequency
};

/// The liquid in which the tip of the pipette is immersed.
struct Bath {
  BathModel model = BathModel::none;  ///< model of its load
  Liquid liquid;                      ///< at rest, far from any wall
  double immersed_length = 0;   ///< from the tip [m]; the whole pipette if this exceeds its length
  double frequency = 10e3;      ///< of BathModel::constant [Hz]
  double drag_coefficient = 0;  ///< C_D of a quadratic drag rho C_D outer_diameter |v| v / 2
};

/// Injection pipette clamped in its capillary: a glass tube with fluids in its bore. The defaults
/// are those of Tables 5.5 and 5.6. Besides the properties of the tube it has options of the
/// computation: number of elements, Rayleigh damping C = alpha M + beta K.
struct Pipette {
  double length = 10e-3;            ///< free length [m]
  double outer_diameter = 10e-6;    ///< [m]
  double inner_diameter = 8e-6;     ///< [m]
  double youngs_modulus = 63.44e9;  ///< of the glass [Pa]
  double density = 2300;            ///< of the glass [kg/m^3]
  double fill_density = 0;          ///< of the fluid in the bore [kg/m^3]
  /// Viscosity of that fluid [Pa s], with which it follows the wall in motion along the pipette. In
  /// motion across the pipette the fluid follows completely.
  double fill_viscosity = Liquid{}.viscosity;
  int elements = 20;         ///< cubic elements
  double damping_alpha = 0;  ///< mass-proportional Rayleigh damping [1/s]
  double damping_beta = 0;   ///< stiffness-proportional Rayleigh damping [s]

  /// Loss factor tan(delta) of the glass, the same at all frequencies; youngs_modulus is then the
  /// storage modulus at loss_frequency [Hz]. Modal superposition uses half of it as the damping
  /// ratio of every mode.
  double loss_factor = 0;
  double loss_frequency = 10e3;  ///< [Hz]

  /// Diameters by increasing distance from the tip, linear between entries and constant beyond
  /// them; empty for the two diameters above everywhere.
  std::vector<Diameters> profile{};
  /// Columns of fluid that replace the fill; later entries overwrite earlier ones.
  std::vector<FillColumn> columns{};
  Bath bath{};  ///< around the tip
};

/// Throws std::invalid_argument with the value, the limit and the remedy unless the pipette is a
/// tube (0 <= inner < outer diameter), slender enough for Euler-Bernoulli theory (length at least
/// ten diameters), of positive modulus and density, and without negative damping.
void check(const Pipette& pipette);

/// Diameters at the distance x [m] from the support.
Diameters diameters_at(const Pipette& pipette, double x);

/// Area of the glass ring, pi (D^2 - d^2) / 4 [m^2].
double glass_area(const Diameters& diameters);

/// Second moment of area of the glass ring, pi (D^4 - d^4) / 64 [m^4].
double second_moment_of_area(const Diameters& diameters);

/// Mass of glass and fill per length, pi/4 ((D^2 - d^2) rho + d^2 rho_fill) [kg/m].
double mass_per_length(const Diameters& diameters, double glass_density, double fill_density);

/// @{
/// The same for a pipette without profile and columns.
double second_moment_of_area(const Pipette& pipette);
double mass_per_length(const Pipette& pipette);
/// @}

/// True if the section is uniform: no profile, no columns.
bool is_uniform(const Pipette& pipette);

/// A uniform pipette without bath, for the analytic solutions. Calls check(); throws
/// std::invalid_argument if the section is not uniform.
UniformBeam uniform_beam(const Pipette& pipette);

/// Section along x from the support, for the finite elements. Calls check().
Section section_of(const Pipette& pipette);

/// Fluid in the bore at the distance x [m] from the support.
Liquid fill_at(const Pipette& pipette, double x);

/// Start of the immersed part, as distance from the support [m]; the length if nothing is immersed.
double immersed_from(const Pipette& pipette);

}  // namespace zona::beam
