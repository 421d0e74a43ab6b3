#include "mpm/pressure/multigrid.h"

#include <algorithm>

namespace zona::mpm {

namespace {

/// Cells along the longest axis of the coarsest lattice.
constexpr int coarsest = 2;
constexpr int sweeps_at_coarsest = 4;
/// Levels of fewer places are left to one thread: waiting for others would take longer.
constexpr long fewest_shared_places = 20000;

bool is_shared(const CellLattice& lattice) {
  return lattice.last - lattice.first >= fewest_shared_places;
}

/// Calls f(n) for n below count, by all threads together or by the calling one.
template <class F>
void for_each_index(bool shared, long count, F f) {
  if (shared) {
#pragma omp for schedule(static)
    for (long n = 0; n < count; ++n) f(n);
  } else {
    for (long n = 0; n < count; ++n) f(n);
  }
}

CellLattice halved(const CellLattice& fine) {
  return CellLattice({(fine.cells[0] + 1) / 2, (fine.cells[1] + 1) / 2, (fine.cells[2] + 1) / 2});
}

/// Calls f(j, k, place of its first cell, number of cells) for the rows of a lattice.
template <class F>
void for_each_row(const CellLattice& lattice, bool shared, F f) {
  for_each_index(shared, static_cast<long>(lattice.cells[1]) * lattice.cells[2], [&](long r) {
    const int j = static_cast<int>(r % lattice.cells[1]);
    const int k = static_cast<int>(r / lattice.cells[1]);
    f(j, k, lattice.place(0, j, k), lattice.cells[0]);
  });
}

/// Calls f(begin, end) for pieces of all places of a lattice.
template <class F>
void for_each_piece(const CellLattice& lattice, F f) {
  constexpr long length = 1024;
  const long count = (lattice.last - lattice.first + length - 1) / length;
  for_each_index(is_shared(lattice), count, [&](long n) {
    const long begin = lattice.first + n * length;
    f(begin, std::min(lattice.last, begin + length));
  });
}

}  // namespace

CellLaplacian::CellLaplacian(const CellLattice& l) : lattice(l) {
  const FloatField zero(l.size, 0.0f);
  coupling.fill(zero);
  excess = zero;
}

Multigrid::Level::Level(const CellLattice& lattice) : laplacian(lattice) {
  const FloatField zero(lattice.size, 0.0f);
  inverse_diagonal.fill(zero);
  unknown = right = residual = zero;
}

Multigrid::Multigrid(const CellLattice& lattice) : finest_(lattice) {
  CellLattice last = lattice;
  while (*std::max_element(last.cells.begin(), last.cells.end()) > coarsest) {
    last = halved(last);
    levels_.emplace_back(last);
  }
}

void Multigrid::set_diagonal(Level& level) {
  const CellLaplacian& l = level.laplacian;
  const long along[3] = {1, l.lattice.row, l.lattice.layer};
  for_each_row(l.lattice, is_shared(l.lattice), [&](int j, int k, long place, int n) {
    for (int i = 0; i < n; ++i) {
      const long c = place + i;
      float sum = l.excess[c];
      for (int axis = 0; axis < 3; ++axis)
        sum += l.coupling[axis][c] + l.coupling[axis][c - along[axis]];
      level.inverse_diagonal[(i + j + k) % 2][c] = sum > 0 ? 1 / sum : 0;
    }
  });
}

void Multigrid::coarsen(const CellLaplacian& fine, CellLaplacian& coarse) {
  const long along[3] = {1, fine.lattice.row, fine.lattice.layer};
  for_each_row(coarse.lattice, is_shared(fine.lattice), [&](int j, int k, long place, int n) {
    for (int i = 0; i < n; ++i) {
      const long lowest = fine.lattice.place(2 * i, 2 * j, 2 * k);
      float excess = 0;
      for (int corner = 0; corner < 8; ++corner) {
        excess +=
            fine.excess[lowest + corner % 2 + corner / 2 % 2 * along[1] + corner / 4 * along[2]];
      }
      coarse.excess[place + i] = excess;
      for (int axis = 0; axis < 3; ++axis) {
        // Four faces side by side, over twice the distance.
        const float* c = fine.coupling[axis].data() + lowest + along[axis];
        const long u = along[axis == 0 ? 1 : 0];
        const long w = along[axis == 2 ? 1 : 2];
        coarse.coupling[axis][place + i] = 0.5f * (c[0] + c[u] + c[w] + c[u + w]);
      }
    }
  });
}

void Multigrid::set(const CellLaplacian& finest) {
  if (is_shared(finest.lattice)) {
    set_levels(0, finest);
  } else {
#pragma omp single
    set_levels(0, finest);
  }
}

void Multigrid::set_levels(std::size_t n, const CellLaplacian& fine) {
  if (n == levels_.size()) return;
  Level& level = levels_[n];
  coarsen(fine, level.laplacian);
  const auto set_rest = [&] {
    set_diagonal(level);
    set_levels(n + 1, level.laplacian);
  };
  if (is_shared(fine.lattice) && !is_shared(level.laplacian.lattice)) {
#pragma omp single
    set_rest();
  } else {
    set_rest();
  }
}

void Multigrid::smooth(Level& level, int colour, bool from_zero) {
  const long row = level.laplacian.lattice.row;
  const long layer = level.laplacian.lattice.layer;
  const float* d = level.inverse_diagonal[colour].data();
  const float* b = level.right.data();
  const float* kx = level.laplacian.coupling[0].data();
  const float* ky = level.laplacian.coupling[1].data();
  const float* kz = level.laplacian.coupling[2].data();
  float* x = level.unknown.data();
  for_each_piece(level.laplacian.lattice, [&](long begin, long end) {
    if (from_zero) {
#pragma omp simd
      for (long c = begin; c < end; ++c) x[c] = d[c] * b[c];
      return;
    }
#pragma omp simd
    for (long c = begin; c < end; ++c) {
      const float sum = b[c] + kx[c] * x[c + 1] + kx[c - 1] * x[c - 1] + ky[c] * x[c + row] +
                        ky[c - row] * x[c - row] + kz[c] * x[c + layer] +
                        kz[c - layer] * x[c - layer];
      if (d[c] > 0) x[c] = d[c] * sum;
    }
  });
}

void Multigrid::set_residual(Level& level) {
  const long row = level.laplacian.lattice.row;
  const long layer = level.laplacian.lattice.layer;
  const float* even = level.inverse_diagonal[0].data();
  const float* odd = level.inverse_diagonal[1].data();
  const float* b = level.right.data();
  const float* kx = level.laplacian.coupling[0].data();
  const float* ky = level.laplacian.coupling[1].data();
  const float* kz = level.laplacian.coupling[2].data();
  const float* x = level.unknown.data();
  float* r = level.residual.data();
  for_each_piece(level.laplacian.lattice, [&](long begin, long end) {
#pragma omp simd
    for (long c = begin; c < end; ++c) {
      const float d = even[c] + odd[c];
      const float sum = b[c] + kx[c] * x[c + 1] + kx[c - 1] * x[c - 1] + ky[c] * x[c + row] +
                        ky[c - row] * x[c - row] + kz[c] * x[c + layer] +
                        kz[c - layer] * x[c - layer];
      r[c] = d > 0 ? sum - x[c] / d : 0.0f;
    }
  });
}

void Multigrid::restrict_to(Level& coarse, const CellLattice& lattice, const FloatField& fine) {
  constexpr float weight[4] = {0.25f, 0.75f, 0.75f, 0.25f};
  for_each_row(coarse.laplacian.lattice, is_shared(lattice), [&](int j, int k, long place, int n) {
    // Sums over rows beside each other, from one place before the first cell.
    const float* from = fine.data() + lattice.place(-1, 2 * j - 1, 2 * k - 1);
    const int length = 2 * n + 2;
    std::vector<float> sum(length, 0.0f);
    for (int row = 0; row < 16; ++row) {
      const float w = weight[row % 4] * weight[row / 4];
      const float* p = from + row % 4 * lattice.row + row / 4 * lattice.layer;
#pragma omp simd
      for (int i = 0; i < length; ++i) sum[i] += w * p[i];
    }
    float* right = coarse.right.data() + place;
    for (int i = 0; i < n; ++i) {
      const float* s = sum.data() + 2 * i;
      right[i] = 0.25f * (s[0] + s[3]) + 0.75f * (s[1] + s[2]);
    }
  });
}

void Multigrid::add_prolonged(const Level& coarse, const CellLattice& lattice, FloatField& fine) {
  const CellLattice& above = coarse.laplacian.lattice;
  for_each_row(above, is_shared(lattice), [&](int j, int k, long place, int n) {
    // By 3/4 from the cell itself, by 1/4 from the next, along each axis.
    const float* here = coarse.unknown.data() + place - 1;
    std::vector<float> sum(n + 2);
    for (int corner = 0; corner < 4; ++corner) {
      const long y = corner % 2 == 0 ? -above.row : above.row;
      const long z = corner / 2 == 0 ? -above.layer : above.layer;
#pragma omp simd
      for (int i = 0; i < n + 2; ++i) {
        sum[i] =
            0.5625f * here[i] + 0.1875f * (here[i + y] + here[i + z]) + 0.0625f * here[i + y + z];
      }
      float* to = fine.data() + lattice.place(0, 2 * j + corner % 2, 2 * k + corner / 2);
      for (int i = 0; i < n; ++i) {
        to[2 * i] += 0.75f * sum[i + 1] + 0.25f * sum[i];
        to[2 * i + 1] += 0.75f * sum[i + 1] + 0.25f * sum[i + 2];
      }
    }
  });
}

void Multigrid::cycle(std::size_t n) {
  Level& level = levels_[n];
  const CellLattice& lattice = level.laplacian.lattice;
  smooth(level, 0, true);
  smooth(level, 1);
  if (n + 1 < levels_.size()) {
    set_residual(level);
    correct(n + 1, lattice, level.residual, level.unknown);
  } else {
    for (int sweep = 0; sweep < sweeps_at_coarsest; ++sweep) {
      for (int colour : {0, 1, 1, 0}) smooth(level, colour);
    }
  }
  smooth(level, 1);
  smooth(level, 0);
}

/// Adds to z the correction by level n for the residual r of the lattice below it.
void Multigrid::correct(std::size_t n, const CellLattice& fine, const FloatField& r,
                        FloatField& z) {
  Level& level = levels_[n];
  restrict_to(level, fine, r);
  if (is_shared(fine) && !is_shared(level.laplacian.lattice)) {
#pragma omp single
    cycle(n);
  } else {
    cycle(n);
  }
  add_prolonged(level, fine, z);
}

void Multigrid::add_correction(const FloatField& r, FloatField& z) {
  if (levels_.empty()) return;
  if (is_shared(finest_)) {
    correct(0, finest_, r, z);
  } else {
#pragma omp single
    correct(0, finest_, r, z);
  }
}

}  // namespace zona::mpm
