#pragma once

#include <complex>
#include <vector>

#include "beam/pipette/hydrodynamics.h"

namespace zona::beam {

/// A uniform piece of a beam.
struct UniformPiece {
  double length = 0;             ///< [m]
  double flexural_rigidity = 0;  ///< EI [N m^2]
  double mass_per_length = 0;    ///< [kg/m]
  double radius = 0;             ///< outer radius [m]; 0 for a piece that is not immersed
};

/// Absolute motion of the tip over that of the clamped end in the Laplace variable s [1/s], for
/// pieces joined from the clamped end to the free tip, in a liquid where their radius is not 0.
/// Exact solution of Euler-Bernoulli theory, EI v'''' + (m s^2 + rho pi a^2 s^2 + s f(s)) v = 0
/// with `viscous_load` f, which is all that it shares with the finite elements.
std::complex<double> exact_transfer(const std::vector<UniformPiece>& pieces, const Liquid& liquid,
                                    std::complex<double> s);

/// A uniform piece of a filled tube that vibrates along its axis.
struct UniformRodPiece {
  double length = 0;           ///< [m]
  double axial_rigidity = 0;   ///< EA [N]
  double mass_per_length = 0;  ///< of the glass [kg/m]
  double outer_radius = 0;     ///< [m]; 0 for a piece that is not immersed
  double inner_radius = 0;     ///< [m]
  Liquid fill{0};              ///< in the bore; density 0 for an empty bore
};

/// The same ratio for motion along the pipette, EA u'' = (m s^2 + s f(s)) u with the sum f of the
/// `viscous_load`s of bath and fill.
std::complex<double> exact_rod_transfer(const std::vector<UniformRodPiece>& pieces,
                                        const Liquid& liquid, std::complex<double> s);

}  // namespace zona::beam
