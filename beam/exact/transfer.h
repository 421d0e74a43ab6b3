#pragma once

#include <complex>
#include <vector>

#include "beam/pipette/hydrodynamics.h"

namespace zona::beam {

/// A piece of a beam that is the same along its length.
struct UniformPiece {
  double length = 0;             ///< [m]
  double flexural_rigidity = 0;  ///< EI [N m^2]
  double mass_per_length = 0;    ///< [kg/m]
  double radius = 0;             ///< of the outside [m]; 0 outside any liquid
};

/// Absolute motion of the tip over that of the clamped end in the Laplace variable s, of pieces
/// joined from the clamped end to the free tip, in a liquid where their radius is not 0. Euler-
/// Bernoulli theory solved exactly, EI v'''' + (m s^2 + rho pi a^2 s^2 + s f(s)) v = 0 with f of
/// `viscous_load`: nothing is shared with the finite elements but the load.
std::complex<double> exact_transfer(const std::vector<UniformPiece>& pieces, const Liquid& liquid,
                                    std::complex<double> s);

/// A piece of a filled tube that vibrates along itself.
struct UniformRodPiece {
  double length = 0;           ///< [m]
  double axial_rigidity = 0;   ///< EA [N]
  double mass_per_length = 0;  ///< of the glass [kg/m]
  double outer_radius = 0;     ///< [m]; 0 outside any liquid
  double inner_radius = 0;     ///< [m]
  Liquid fill{0};              ///< of the bore; of density 0: nothing
};

/// The same of the tip's motion along the pipette, EA u'' = (m s^2 + s f(s)) u with the
/// `viscous_load`s f of bath and fill.
std::complex<double> exact_rod_transfer(const std::vector<UniformRodPiece>& pieces,
                                        const Liquid& liquid, std::complex<double> s);

}  // namespace zona::beam
