#include "beam/frequency/transfer_sensitivity.h"

#include <fmt/format.h>

#include <algorithm>

#include "beam/algebra/require.h"
#include "beam/frequency/frequency_lanes.h"
#include "beam/frequency/transfer_function.h"

namespace zona::beam {
namespace {

using namespace lanes;

bool same_load(const ViscousLoad& a, const ViscousLoad& b) {
  return a.flow == b.flow && a.model == b.model && a.radius == b.radius &&
         a.liquid.density == b.liquid.density && a.liquid.viscosity == b.liquid.viscosity &&
         (a.model != BathModel::constant || a.angular_frequency == b.angular_frequency);
}

/// True if two beams have the same loads and moduli at every frequency; their matrices may differ.
bool same_factors(const BeamSystem& a, const BeamSystem& b) {
  return a.loss_factor == b.loss_factor &&
         (a.loss_factor == 0 || a.loss_frequency == b.loss_frequency) &&
         a.damping_alpha == b.damping_alpha && a.damping_beta == b.damping_beta &&
         std::equal(a.liquids.viscous.begin(), a.liquids.viscous.end(), b.liquids.viscous.begin(),
                    b.liquids.viscous.end(), same_load);
}

bool differ(const SymmetricBand& a, const SymmetricBand& b) {
  for (int k = 0; k <= half_bandwidth; ++k)
    if (a.diagonal(k) != b.diagonal(k)) return true;
  return false;
}

/// sum += weight (A q + b) of one beam.
inline void add_residual(const BeamSystem& system, const Factors& factors, const BandSolve& band,
                         double weight, std::vector<Complexes>& sum) {
  for (int i = 0; i < system.size(); ++i) {
    add(sum[i], weight, support_entry(system, factors, i));
    for (int k = 0; k <= std::min(i, half_bandwidth); ++k) {
      Complexes entry{};
      add(entry, -weight, matrix_entry(system, factors, i, k));
      subtract_product(sum[i], entry, band.solution(i - k));
      if (k > 0) subtract_product(sum[i - k], entry, band.solution(i));
    }
  }
}

/// q_p = -A^-1 (A_p q + b_p), with the factors of A and q in `band`.
[[gnu::flatten, gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]] void
differentiate(const ParameterStencil& parameter, const std::array<Factors, 4>& factors,
              const BandSolve& band, const BeamSystem& system, std::vector<Complexes>& rates,
              Complexes& observed) {
  for (Complexes& rate : rates) rate = Complexes{};
  for (std::size_t i = 0; i < stencil_weights.size(); ++i)
    add_residual(parameter.moved[i], factors[i], band, -stencil_weights[i] / parameter.step, rates);
  band.solve_again(rates);
  observed = Complexes{};
  for (int i = 0; i < system.size(); ++i)
    if (system.observation(i) != 0) add(observed, system.observation(i), rates[i]);
}

void check(const BeamSystem& system, const std::vector<ParameterStencil>& parameters) {
  TransferFunction{system};  // throws for loads without a transfer function
  for (const ParameterStencil& parameter : parameters)
    for (const BeamSystem& moved : parameter.moved)
      require(
          have_same_structure(moved, system),
          fmt::format("sensitivity: a moved beam has {} degrees of freedom and {} viscous loads "
                      "instead of {} and {}; take a smaller step",
                      moved.size(), moved.liquids.viscous.size(), system.size(),
                      system.liquids.viscous.size()));
}

}  // namespace

bool have_same_structure(const BeamSystem& a, const BeamSystem& b) {
  return a.size() == b.size() && a.liquids.viscous.size() == b.liquids.viscous.size();
}

bool has_effect(const ParameterStencil& stencil) {
  const BeamSystem& a = stencil.moved.front();
  const BeamSystem& b = stencil.moved.back();
  return differ(a.mass, b.mass) || differ(a.stiffness, b.stiffness) || !same_factors(a, b) ||
         (a.liquids.act() && differ(a.liquids.displaced.matrix, b.liquids.displaced.matrix));
}

TransferSensitivity transfer_sensitivity(const BeamSystem& system,
                                         const std::vector<ParameterStencil>& parameters,
                                         const std::vector<Complex>& s) {
  check(system, parameters);
  TransferSensitivity result;
  result.transfer.resize(s.size());
  result.derivative.assign(parameters.size(), std::vector<Complex>(s.size()));
  BandSolve band(system.size());
  std::vector<Complexes> rates(system.size());
  for (std::size_t first = 0; first < s.size(); first += lane_count) {
    const std::size_t count = std::min<std::size_t>(lane_count, s.size() - first);
    std::array<Complex, lane_count> at;
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      at[lane] = s[first + std::min(lane, count - 1)];
    Complexes observed;
    const Factors own = factors_at(system, at.data());
    solve(system, own, band, observed);
    for (std::size_t lane = 0; lane < count; ++lane)
      result.transfer[first + lane] = {observed.re[lane], observed.im[lane]};
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      std::array<Factors, 4> factors;
      for (std::size_t i = 0; i < factors.size(); ++i)
        factors[i] = same_factors(parameters[p].moved[i], system)
                         ? own
                         : factors_at(parameters[p].moved[i], at.data());
      differentiate(parameters[p], factors, band, system, rates, observed);
      for (std::size_t lane = 0; lane < count; ++lane)
        result.derivative[p][first + lane] = {observed.re[lane], observed.im[lane]};
    }
  }
  return result;
}

}  // namespace zona::beam
