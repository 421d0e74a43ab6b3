#pragma once

#include <array>
#include <complex>
#include <vector>

#include "beam/system/beam_system.h"

namespace zona::beam {

/// A beam with one of its parameters p moved by -2, -1, 1 and 2 times `step`: what its matrices'
/// derivatives are taken from, to fourth order. They are smooth in p, mostly polynomials of at most
/// fourth degree, so that a step of a thousandth of p leaves rounding only.
struct ParameterStencil {
  std::array<BeamSystem, 4> moved;  ///< all with as many degrees of freedom as the beam itself
  double step = 0;                  ///< in the unit of p
};

/// A transfer function (`TransferFunction`) and its derivatives.
struct TransferSensitivity {
  std::vector<std::complex<double>> transfer;                 ///< at each s
  std::vector<std::vector<std::complex<double>>> derivative;  ///< by p, one row per parameter
};

/// Whether two beams have the same loads and moduli at every frequency, whatever their matrices.
bool same_factors(const BeamSystem& a, const BeamSystem& b);

/// By forward sensitivity analysis in the Laplace domain: A q = b gives A q_p = b_p - A_p q, which
/// takes one more substitution with the factors of A per parameter. No difference of responses is
/// taken. Throws std::invalid_argument where TransferFunction would, or if a stencil's beams differ
/// in size.
TransferSensitivity transfer_sensitivity(const BeamSystem& system,
                                         const std::vector<ParameterStencil>& parameters,
                                         const std::vector<std::complex<double>>& s);

}  // namespace zona::beam
