#pragma once

#include <array>
#include <complex>
#include <vector>

#include "beam/system/beam_system.h"

namespace zona::beam {

/// Places of a fourth-order difference stencil, in units of the step.
inline constexpr std::array<double, 4> stencil_places{-2, -1, 1, 2};
/// Weights of the first derivative at the `stencil_places`, times the step.
inline constexpr std::array<double, 4> stencil_weights{1. / 12, -8. / 12, 8. / 12, -1. / 12};

/// A beam with one of its parameters p moved to the `stencil_places`, for the derivatives of its
/// matrices. These are smooth in p, mostly polynomials of at most fourth degree, so that a step of
/// a thousandth of p leaves only rounding errors.
struct ParameterStencil {
  std::array<BeamSystem, 4> moved;  ///< all with the structure of the beam itself
  double step = 0;                  ///< in the unit of p
};

/// Values of a `TransferFunction` and its derivatives.
struct TransferSensitivity {
  std::vector<std::complex<double>> transfer;                 ///< at each s
  std::vector<std::vector<std::complex<double>>> derivative;  ///< by p, one row per parameter
};

/// True if two beams have the same numbers of degrees of freedom and of viscous loads.
bool have_same_structure(const BeamSystem& a, const BeamSystem& b);

/// True if the parameter of a stencil changes the beam's equations.
bool has_effect(const ParameterStencil& stencil);

/// Transfer function and its derivatives by forward sensitivity analysis in the Laplace domain:
/// A q = b gives A q_p = b_p - A_p q, one more substitution with the factors of A per parameter.
/// Only matrices are differenced, never responses. Throws std::invalid_argument where
/// TransferFunction does, or if the beams of a stencil have another structure.
TransferSensitivity transfer_sensitivity(const BeamSystem& system,
                                         const std::vector<ParameterStencil>& parameters,
                                         const std::vector<std::complex<double>>& s);

}  // namespace zona::beam
