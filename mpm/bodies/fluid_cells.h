#pragma once

#include <array>
#include <vector>

#include "mpm/grid/cell.h"
#include "mpm/grid/cell_lattice.h"
#include "mpm/materials/fluid.h"

namespace zona::mpm {

/// Sums over the points of a fluid in one cell.
struct FluidSums {
  double volume = 0;  ///< [m^3]
  /// Volume times xi, eta, zeta, xi eta, eta zeta, zeta xi, the natural coordinates [m^3].
  std::array<double, 6> moment{};
  double pressure = 0;    ///< volume times pressure [J]
  double energy = 0;      ///< mass times internal energy [J]
  double mass = 0;        ///< [kg]
  double mass_sound = 0;  ///< mass times speed of sound [kg m/s], with linear artificial viscosity
};

/// Adds up FluidSums from the points of a cell, eight at a time.
class CellSummation {
 public:
  /// Adds a group of points at natural coordinates in [0, 1].
  void add(const Fluid& fluid, const MaterialPoints& points, const PointGroup& group,
           const std::array<Lanes, 3>& natural) {
    Lanes mass = group.load(points.mass);
    if (group.count() < lane_count) {
      const int count = group.count();
      mass *= each_lane([count](int l) { return l < count ? 1.0 : 0.0; });
    }
    const Lanes volume = fluid.volume(group, mass);
    const auto stress = group.load(fluid.stress);
    const Lanes energy = group.load(fluid.internal_energy);
    mass_ += mass;
    volume_ += volume;
    pressure_ -= volume * (trace(stress) / 3.0);
    energy_ += mass * energy;
    for (int i = 0; i < 3; ++i) {
      const Lanes first = volume * natural[i];
      moment_[i] += first;
      moment_[3 + i] += first * natural[(i + 1) % 3];
    }
    if (fluid.properties.artificial_viscosity.linear > 0)
      mass_sound_ += mass * fluid.sound_speed(group.load(fluid.density), energy);
  }
  /// The sums of all points added.
  FluidSums sums() const {
    FluidSums s;
    for (int l = 0; l < lane_count; ++l) {
      s.volume += volume_[l];
      s.pressure += pressure_[l];
      s.energy += energy_[l];
      s.mass += mass_[l];
      s.mass_sound += mass_sound_[l];
      for (int i = 0; i < 6; ++i) s.moment[i] += moment_[i][l];
    }
    return s;
  }

 private:
  Lanes volume_{};
  Lanes moment_[6]{};
  Lanes pressure_{};
  Lanes energy_{};
  Lanes mass_{};
  Lanes mass_sound_{};
};

/// A fluid by cells, for a step whose pressure is implicit.
struct FluidCells {
  /// Empty cells.
  explicit FluidCells(const BackgroundGrid& grid)
      : lattice(grid.cells()), sums(lattice.size), divergence(lattice.size, 0.0) {}

  CellLattice lattice;          ///< places of the cells
  std::vector<FluidSums> sums;  ///< per place, at the start of a step
  Field divergence;             ///< mean rate of volumetric strain in the running step [1/s]

  /// Place of a cell.
  long place(const Cell& cell) const {
    return lattice.place(cell.index[0], cell.index[1], cell.index[2]);
  }
};

}  // namespace zona::mpm
