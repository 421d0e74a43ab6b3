#include "mpm/pressure/implicit_pressure.h"

#include <fmt/format.h>

#include <cmath>

#include "mpm/points/errors.h"
#include "mpm/pressure/cell_law.h"

namespace zona::mpm {

namespace {

constexpr int most_linearisations = 50;
/// Volumetric strain whose error is round-off.
constexpr double negligible_strain = 1e-13;

std::size_t count_fluids(const std::vector<Body>& bodies) {
  return std::count_if(bodies.begin(), bodies.end(), [](const Body& body) {
    return std::holds_alternative<mpm::Fluid>(body.material);
  });
}

/// theta for the square of a cell's Courant number; not zero, because the system divides by it.
double implicitness(double courant_square) {
  return std::max(1e-3, 1 - 0.25 / courant_square);
}

const FluidProperties& properties_of(const Body& body) {
  return std::get<mpm::Fluid>(body.material).properties;
}

}  // namespace

ImplicitPressure::ImplicitPressure(const BackgroundGrid& grid, std::vector<Body>& bodies,
                                   double tolerance, double dt, int threads)
    : flow(CellLattice(grid.cells())),
      tolerance_(tolerance),
      dt_(dt),
      length_(grid.characteristic_length()),
      inverse_cell_(grid.inverse_cell_size()),
      threads_(threads),
      lattice_(grid.cells()),
      loop_(lattice_),
      system_(lattice_, count_fluids(bodies), threads) {
  if (!(tolerance >= 1e-10 && tolerance <= 0.1)) {
    throw ModelError(
        fmt::format("the tolerance of the pressure must lie in [1e-10, 0.1], got {}", tolerance));
  }
  if (grid.interpolation() == Interpolation::quadratic) {
    throw ModelError(
        "implicit pressure needs linear shape functions: with quadratic ones a cell's pressure "
        "would act on 27 nodes");
  }
  const Field zero(lattice_.size, 0.0);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!std::holds_alternative<mpm::Fluid>(bodies[b].material)) continue;
    bodies[b].fluid_cells.emplace(grid);
    fluids_.push_back({b, FloatField(lattice_.size, 0.0f), zero, zero, zero, zero, zero});
  }
}

void ImplicitPressure::start(Body& body, std::size_t f, const Chunk& chunk) {
  PressureSystem::Fluid& fluid = system_.fluids[f];
  const std::vector<FluidSums>& sums = body.fluid_cells->sums;
  char& occupied = fluid.occupied_chunk[chunk.number];
  const bool was_occupied = occupied;
  occupied = std::any_of(sums.begin() + chunk.begin, sums.begin() + chunk.end,
                         [](const FluidSums& s) { return s.volume > 0; });
  if (!occupied && !was_occupied) return;
  for (long c = chunk.begin; c < chunk.end; ++c) {
    fluid.gradient.set(c, sums[c], inverse_cell_);
    fluid.pressure[c] = sums[c].volume > 0 ? sums[c].pressure / sums[c].volume : 0;
    fluid.compliance[c] = 0;
    fluids_[f].strain[c] = 0;
    body.fluid_cells->divergence[c] = 0;
  }
  set_implicitness(body, f, chunk);
}

void ImplicitPressure::set_implicitness(const Body& body, std::size_t f, const Chunk& chunk) {
  Fluid& fluid = fluids_[f];
  std::fill(fluid.diagonal.begin() + chunk.begin, fluid.diagonal.begin() + chunk.end, 0.0f);
  system_.fluids[f].gradient.add_diagonal(flow.mobility, chunk, fluid.diagonal.data());
  for (long c = chunk.begin; c < chunk.end; ++c) {
    const FluidSums& sums = body.fluid_cells->sums[c];
    if (!(sums.volume > 0)) continue;
    const double stiffness = CellLaw(properties_of(body), sums, dt_, length_).stiffness(0);
    // A full cell among others has the diagonal 1.5 V / (rho h^2).
    fluid.implicitness[c] =
        implicitness(dt_ * dt_ * stiffness / sums.volume * fluid.diagonal[c] / 1.5);
  }
}

/// Sets up the system at the present strains. Returns sums of squares: of the expansion by the
/// flow, and of a strain of one, as they are in the right-hand side.
std::array<double, 2> ImplicitPressure::linearise(const Body& body, std::size_t f,
                                                  const Chunk& chunk) {
  PressureSystem::Fluid& system = system_.fluids[f];
  if (!system.occupied_chunk[chunk.number]) return {};
  Fluid& fluid = fluids_[f];
  std::array<double, 2> squares{};
  for (long c = chunk.begin; c < chunk.end; ++c) {
    const FluidSums& sums = body.fluid_cells->sums[c];
    if (!(sums.volume > 0)) continue;
    const CellLaw law(properties_of(body), sums, dt_, length_);
    const double x = fluid.strain[c];
    const double theta = fluid.implicitness[c];
    const double before = sums.pressure / sums.volume;
    fluid.acting[c] = before + theta * (law.pressure(x) - before);
    fluid.softness[c] = 1 / (theta * law.stiffness(x));
    const double scale = sums.volume / (dt_ * dt_);
    const double flow = fluid.expansion[c] / dt_;
    system.compliance[c] = scale * fluid.softness[c];
    system.right[c] = scale * (fluid.acting[c] * fluid.softness[c] + x) - flow;
    squares[0] += flow * flow;
    squares[1] += scale * scale;
  }
  return squares;
}

/// Takes over the strains of the solution; returns the greatest error of the law in a strain.
double ImplicitPressure::accept(Body& body, std::size_t f, const Chunk& chunk) {
  const PressureSystem::Fluid& system = system_.fluids[f];
  if (!system.occupied_chunk[chunk.number]) return 0;
  Fluid& fluid = fluids_[f];
  double worst = 0;
  for (long c = chunk.begin; c < chunk.end; ++c) {
    const FluidSums& sums = body.fluid_cells->sums[c];
    if (!(sums.volume > 0)) continue;
    const CellLaw law(properties_of(body), sums, dt_, length_);
    double& x = fluid.strain[c];
    // At most half the way to the strain at which the law ends.
    x = std::max(x - (system.pressure[c] - fluid.acting[c]) * fluid.softness[c],
                 0.5 * (law.lowest() + std::min(x, 0.0)));
    const double theta = fluid.implicitness[c];
    const double before = sums.pressure / sums.volume;
    const double acting = before + theta * (law.pressure(x) - before);
    worst = std::max(worst, std::abs(system.pressure[c] - acting) / (theta * law.stiffness(x)));
    body.fluid_cells->divergence[c] = x / dt_;
  }
  return worst;
}

const std::array<Field, 3>& ImplicitPressure::solve(std::vector<Body>& bodies, long step) {
#pragma omp parallel num_threads(threads_)
  loop_.each([&](const Chunk& chunk) {
    for (std::size_t f = 0; f < fluids_.size(); ++f) {
      start(bodies[fluids_[f].body], f, chunk);
      if (!system_.fluids[f].occupied_chunk[chunk.number]) continue;
      system_.fluids[f].gradient.expand<double>(
          {flow.velocity[0].data(), flow.velocity[1].data(), flow.velocity[2].data()}, chunk,
          fluids_[f].expansion.data());
    }
  });
  system_.mobility = flow.mobility;
  for (int n = 0; n < most_linearisations; ++n) {
    std::array<double, 2> squares{};
    double worst = 0;
#pragma omp parallel num_threads(threads_)
    {
      const auto sums = loop_.sums(0, [&](const Chunk& chunk) {
        std::array<double, 2> of_chunk{};
        for (std::size_t f = 0; f < fluids_.size(); ++f) {
          const auto of_fluid = linearise(bodies[fluids_[f].body], f, chunk);
          for (int i = 0; i < 2; ++i) of_chunk[i] += of_fluid[i];
        }
        return of_chunk;
      });
#pragma omp master
      squares = sums;
    }
    const auto outcome =
        system_.solve(std::sqrt(squares[0]), tolerance_, negligible_strain * std::sqrt(squares[1]));
    ++systems_;
    iterations_ += outcome.iterations;
    if (!outcome.converged) {
      fail(bodies, step,
           fmt::format("the implicit pressure does not converge: after {} iterations the residual "
                       "is {:.3g}, the tolerance {:.3g}",
                       outcome.iterations, outcome.residual, tolerance_));
    }
#pragma omp parallel num_threads(threads_)
    {
      const double most = loop_.maximum(1, [&](const Chunk& chunk) {
        double of_chunk = 0;
        for (std::size_t f = 0; f < fluids_.size(); ++f)
          of_chunk = std::max(of_chunk, accept(bodies[fluids_[f].body], f, chunk));
        return of_chunk;
      });
#pragma omp master
      worst = most;
    }
    if (!(worst > balance_tolerance)) return system_.forces();
  }
  fail(bodies, step,
       fmt::format("the equation of state is not met within {} linearisations",
                   most_linearisations));
}

void ImplicitPressure::fail(const std::vector<Body>& bodies, long step,
                            const std::string& what) const {
  const auto [fluid, place] = system_.worst_cell();
  const auto [i, j, k] = lattice_.indices(place);
  throw StepError(
      fmt::format("{}; worst in cell ({}, {}, {}) of body '{}' in step {}, time {:.6g} s: choose a "
                  "smaller step or a larger tolerance",
                  what, i, j, k, bodies[fluids_[fluid].body].name, step, step * dt_));
}

}  // namespace zona::mpm
