#include "mpm/pressure/pressure_system.h"

#include <algorithm>
#include <cmath>

namespace zona::mpm {

namespace {

/// Reduction of the residual in single precision before it is computed in double again.
constexpr double trusted_reduction = 1e-4;
constexpr int most_trusted = 200;  // iterations likewise
constexpr int most_iterations = 5000;

double dot(const FloatField& a, const FloatField& b, const Chunk& chunk) {
  float sum = 0;
#pragma omp simd reduction(+ : sum)
  for (long c = chunk.begin; c < chunk.end; ++c) sum += a[c] * b[c];
  return sum;
}

template <class Values>
void clear(Values& values, const Chunk& chunk) {
  std::fill(values.begin() + chunk.begin, values.begin() + chunk.end, 0);
}

}  // namespace

PressureSystem::Fluid::Fluid(const CellLattice& lattice)
    : gradient(lattice),
      compliance(lattice.size, 0.0),
      right(compliance),
      pressure(compliance),
      occupied_chunk(LatticeLoop(lattice).count(), 0) {}

PressureSystem::Work::Work(const CellLattice& lattice) {
  compliance.assign(lattice.size, 0.0f);
  inverse_diagonal = residual = preconditioned = product = search = correction = compliance;
}

PressureSystem::PressureSystem(const CellLattice& lattice, std::size_t count, int threads)
    : fluids(count, Fluid(lattice)),
      lattice_(lattice),
      loop_(lattice),
      threads_(threads),
      work_(count, Work(lattice)),
      all_fluids_(lattice),
      multigrid_(lattice),
      summed_residual_(lattice.size, 0.0f),
      long_waves_(summed_residual_) {
  mobility.fill(summed_residual_);
  nodal_.fill(summed_residual_);
  force_.fill(Field(lattice.size, 0.0));
}

bool PressureSystem::reaches(const Fluid& fluid, const Chunk& chunk) const {
  const long lowest = loop_.chunk_of(chunk.begin - lattice_.layer - lattice_.row - 1);
  for (long c = lowest; c <= chunk.number; ++c) {
    if (fluid.occupied_chunk[c]) return true;
  }
  return false;
}

std::pair<std::size_t, long> PressureSystem::worst_cell() const {
  std::pair<std::size_t, long> worst{0, lattice_.first};
  const auto residual = [this](std::size_t i, long c) { return std::abs(work_[i].residual[c]); };
  for (std::size_t i = 0; i < fluids.size(); ++i) {
    for (long c = lattice_.first; c < lattice_.last; ++c) {
      if (residual(i, c) > residual(worst.first, worst.second)) worst = {i, c};
    }
  }
  return worst;
}

template <class Real>
void PressureSystem::set_forces(const std::vector<const Real*>& pressures, const Chunk& chunk,
                                const std::array<Real*, 3>& force) const {
  bool is_first = true;
  for (std::size_t i = 0; i < fluids.size(); ++i) {
    if (!reaches(fluids[i], chunk)) continue;
    if (is_first) {
      fluids[i].gradient.forces<false>(pressures[i], chunk, force);
    } else {
      fluids[i].gradient.forces<true>(pressures[i], chunk, force);
    }
    is_first = false;
  }
  if (!is_first) return;
  for (auto* f : force) std::fill(f + chunk.begin, f + chunk.end, Real{});
}

const std::array<Field, 3>& PressureSystem::forces() {
  std::vector<const double*> pressures;
  for (const Fluid& fluid : fluids) pressures.push_back(fluid.pressure.data());
#pragma omp parallel num_threads(threads_)
  loop_.each([&](const Chunk& chunk) {
    set_forces(pressures, chunk, {force_[0].data(), force_[1].data(), force_[2].data()});
  });
  return force_;
}

/// Residuals of the pressures, in double precision; returns the square of their norm.
double PressureSystem::set_residual() {
  std::vector<const double*> pressures;
  for (const Fluid& fluid : fluids) pressures.push_back(fluid.pressure.data());
  loop_.each([&](const Chunk& chunk) {
    set_forces(pressures, chunk, {force_[0].data(), force_[1].data(), force_[2].data()});
    for (int axis = 0; axis < 3; ++axis) {
      double* f = force_[axis].data();
      const float* m = mobility[axis].data();
#pragma omp simd
      for (long n = chunk.begin; n < chunk.end; ++n) f[n] *= m[n];
    }
  });
  return loop_.sum(0, [&](const Chunk& chunk) {
    double sum = 0;
    std::array<double, LatticeLoop::chunk_length> product;
    for (std::size_t i = 0; i < fluids.size(); ++i) {
      const Fluid& fluid = fluids[i];
      clear(work_[i].residual, chunk);
      if (!fluid.occupied_chunk[chunk.number]) continue;
      fluid.gradient.expand<double>({force_[0].data(), force_[1].data(), force_[2].data()}, chunk,
                                    product.data() - chunk.begin);
      for (long c = chunk.begin; c < chunk.end; ++c) {
        if (!(fluid.compliance[c] > 0)) continue;
        const double r =
            fluid.right[c] - fluid.compliance[c] * fluid.pressure[c] - product[c - chunk.begin];
        work_[i].residual[c] = static_cast<float>(r);
        sum += r * r;
      }
    }
    return sum;
  });
}

void PressureSystem::set_preconditioner() {
  // What a pressure of one in all cells expands is beyond the couplings.
  loop_.each([&](const Chunk& chunk) {
    for (std::size_t i = 0; i < fluids.size(); ++i) {
      const Fluid& fluid = fluids[i];
      Work& work = work_[i];
      for (long c = chunk.begin; c < chunk.end; ++c) {
        work.compliance[c] = static_cast<float>(fluid.compliance[c]);
        work.search[c] = work.compliance[c] > 0 ? 1.0f : 0.0f;
      }
      std::copy_n(work.compliance.begin() + chunk.begin, chunk.end - chunk.begin,
                  work.inverse_diagonal.begin() + chunk.begin);
      fluid.gradient.add_diagonal(mobility, chunk, work.inverse_diagonal.data());
      for (long c = chunk.begin; c < chunk.end; ++c)
        work.inverse_diagonal[c] = work.compliance[c] > 0 ? 1 / work.inverse_diagonal[c] : 0.0f;
    }
  });
  move_nodes();
  loop_.each([&](const Chunk& chunk) {
    for_occupied(chunk, [&](Work& work, const Fluid& fluid) { multiply(fluid, work, chunk); });
    for (long c = chunk.begin; c < chunk.end; ++c) {
      float compliance = 0;
      float rest = 0;
      for (const Work& work : work_) {
        if (!(work.compliance[c] > 0)) continue;
        compliance += work.compliance[c];
        rest += work.product[c] - work.compliance[c];
      }
      all_fluids_.excess[c] = compliance + std::max(rest, 0.0f);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto steps = fluids[0].gradient.steps(axis);
      for (long c = chunk.begin; c < chunk.end; ++c) {
        float sum = 0;
        for (int corner = 0; corner < 4; ++corner) {
          float here = 0;
          float next = 0;
          for (const Fluid& fluid : fluids) {
            here += fluid.gradient.at(axis, corner, c);
            next += fluid.gradient.at(axis, corner, c + steps.along);
          }
          sum += mobility[axis][c + steps.along + steps.to(corner)] * here * next;
        }
        // A node shares its force among the four cells on each side.
        all_fluids_.coupling[axis][c] = 4 * sum;
      }
    }
  });
  multigrid_.set(all_fluids_);
}

/// Sets `preconditioned` to the preconditioner's product with the residual, whose sum over the
/// fluids must stand. Returns the product of both.
double PressureSystem::precondition() {
  multigrid_.add_correction(summed_residual_, long_waves_);
  return loop_.sum(1, [&](const Chunk& chunk) {
    double product = 0;
    for_occupied(chunk, [&](Work& work, const Fluid&) {
      float* z = work.preconditioned.data();
      const float* r = work.residual.data();
      const float* d = work.inverse_diagonal.data();
      const float* waves = long_waves_.data();
#pragma omp simd
      for (long c = chunk.begin; c < chunk.end; ++c)
        z[c] = d[c] > 0 ? d[c] * r[c] + waves[c] : 0.0f;
      product += dot(work.preconditioned, work.residual, chunk);
    });
    return product;
  });
}

/// Velocities of the nodes by `search` as pressure.
void PressureSystem::move_nodes() {
  std::vector<const float*> pressures;
  for (const Work& work : work_) pressures.push_back(work.search.data());
  loop_.each([&](const Chunk& chunk) {
    set_forces(pressures, chunk, {nodal_[0].data(), nodal_[1].data(), nodal_[2].data()});
    for (int axis = 0; axis < 3; ++axis) {
      float* f = nodal_[axis].data();
      const float* m = mobility[axis].data();
#pragma omp simd
      for (long n = chunk.begin; n < chunk.end; ++n) f[n] *= m[n];
    }
  });
}

/// Sets `product` of a chunk to the system's product with `search`, after `move_nodes`.
void PressureSystem::multiply(const Fluid& fluid, Work& work, const Chunk& chunk) const {
  float* product = work.product.data();
  const float* s = work.search.data();
  const float* compliance = work.compliance.data();
  fluid.gradient.expand<float>({nodal_[0].data(), nodal_[1].data(), nodal_[2].data()}, chunk,
                               product);
#pragma omp simd
  for (long c = chunk.begin; c < chunk.end; ++c)
    product[c] = compliance[c] > 0 ? product[c] + compliance[c] * s[c] : 0.0f;
}

/// Prepares the next `precondition`.
void PressureSystem::sum_residuals(const Chunk& chunk) {
  clear(long_waves_, chunk);
  clear(summed_residual_, chunk);
  for_occupied(chunk, [&](Work& work, const Fluid&) {
    float* sum = summed_residual_.data();
    const float* r = work.residual.data();
#pragma omp simd
    for (long c = chunk.begin; c < chunk.end; ++c) sum[c] += r[c];
  });
}

/// Conjugate gradients from zero until the norm of the residual is `enough`; adds the correction to
/// the pressures. Returns the number of iterations.
int PressureSystem::reduce(double enough, int most) {
  loop_.each([&](const Chunk& chunk) {
    for (Work& work : work_) {
      clear(work.correction, chunk);
      clear(work.search, chunk);
    }
    sum_residuals(chunk);
  });
  double rz = 0;
  int iteration = 0;
  for (double square = HUGE_VAL; iteration < most && square > enough * enough; ++iteration) {
    const double last_rz = rz;
    rz = precondition();
    if (!(rz > 0)) break;
    const auto beta = static_cast<float>(iteration == 0 ? 0 : rz / last_rz);
    loop_.each([&](const Chunk& chunk) {
      for_occupied(chunk, [&](Work& work, const Fluid&) {
        float* s = work.search.data();
        const float* z = work.preconditioned.data();
#pragma omp simd
        for (long c = chunk.begin; c < chunk.end; ++c) s[c] = z[c] + beta * s[c];
      });
    });
    move_nodes();
    const double curvature = loop_.sum(1, [&](const Chunk& chunk) {
      double product = 0;
      for_occupied(chunk, [&](Work& work, const Fluid& fluid) {
        multiply(fluid, work, chunk);
        product += dot(work.search, work.product, chunk);
      });
      return product;
    });
    square = loop_.sum(0, [&](const Chunk& chunk) {
      double sum = 0;
      for_occupied(chunk, [&](Work& work, const Fluid&) {
        advance(work, chunk, static_cast<float>(rz / curvature));
        sum += dot(work.residual, work.residual, chunk);
      });
      sum_residuals(chunk);
      return sum;
    });
  }
  loop_.each([&](const Chunk& chunk) {
    for (std::size_t i = 0; i < fluids.size(); ++i) {
      for (long c = chunk.begin; c < chunk.end; ++c)
        fluids[i].pressure[c] += work_[i].correction[c];
    }
  });
  return iteration;
}

/// A step along the search direction in a chunk.
void PressureSystem::advance(Work& work, const Chunk& chunk, float length) {
  float* x = work.correction.data();
  float* r = work.residual.data();
  const float* s = work.search.data();
  const float* p = work.product.data();
#pragma omp simd
  for (long c = chunk.begin; c < chunk.end; ++c) {
    x[c] += length * s[c];
    r[c] -= length * p[c];
  }
}

PressureSystem::Outcome PressureSystem::solve(double norm, double tolerance, double negligible) {
  Outcome outcome{0, 0, false};
#pragma omp parallel num_threads(threads_)
  {
    double residual = std::sqrt(set_residual());
    const double whole = std::max(norm, residual);
    const double enough = std::max(tolerance * whole, negligible);
    int iterations = 0;
    if (residual > enough) set_preconditioner();
    while (residual > enough && iterations < most_iterations) {
      const int taken = reduce(std::max(0.9 * enough, trusted_reduction * residual),
                               std::min(most_trusted, most_iterations - iterations));
      iterations += std::max(taken, 1);
      residual = std::sqrt(set_residual());
    }
#pragma omp master
    outcome = {iterations, whole > 0 ? residual / whole : 0, residual <= enough};
  }
  return outcome;
}

}  // namespace zona::mpm
