#pragma once

#include "mpm/bodies/lattice.h"
#include "mpm/step/solver.h"

namespace zona::studies {

/// The oocyte, the medium around it, the holding plate and the injection pipette of 5.4, SI units.
/// The x axis runs from the plate through the egg into the pipette; y is the lateral direction.
struct PiercingSetup {
  double cell = 6e-6;
  double domain = 150e-6;  ///< edge of the cubic grid; rounded up to whole cells

  struct Zona {
    double diameter = 100e-6;
    int level = 6;  ///< subdivisions of the icosahedron
    mpm::MembraneProperties membrane{1100, 8e-6, 17.9e3, 0.49, mpm::OneWay::stress};
    mpm::MembraneLaw law = mpm::Elastodamage{};
    bool objective = false;
  } zona;

  struct FluidRegion {
    mpm::FluidProperties fluid;
    int points_per_cell;  ///< a cube number
  };
  FluidRegion cytoplasm{{1000, {4.0, 2.12e8}, 0, 8.9e-4, {}}, 27};
  FluidRegion medium{{1000, {4.0, 6.13e8}, 0, 8.9e-4, {}}, 1};

  struct Pipette {
    double outer_diameter = 10e-6;
    double inner_diameter = 8e-6;
    double tip_length = 15e-6;
    std::array<int, 3> points{2, 60, 45};  ///< radial, circumferential, axial
    double density = 26441;  ///< glass and fill, spread over the glass; the source's value
    mpm::Drive drive = mpm::Drive::points;
    mpm::RigidMotion motion;
  } pipette;

  struct Plate {
    bool present = true;
    double side = 72e-6;
    int thickness_cells = 3;
    double density = 2300;
  } plate;

  mpm::Interpolation interpolation = mpm::Interpolation::linear;
  bool average_volume_strain = false;  ///< of the fluids
  mpm::Numerics numerics;

  mpm::FaceConditions faces = all_faces(mpm::FaceCondition::absorbing);

  static mpm::FaceConditions all_faces(mpm::FaceCondition condition) {
    return {condition, condition, condition, condition, condition, condition};
  }
};

/// Where things are in the grid of a setup [m].
struct PiercingGeometry {
  std::array<int, 3> cells;
  Eigen::Vector3d egg_center;
  double egg_radius;
  Eigen::Vector3d plate_low, plate_high;
  mpm::Tube tip;  ///< its end touches the zona
};

/// Throws ModelError where the parts do not fit into the domain.
PiercingGeometry piercing_geometry(const PiercingSetup& setup);

/// Bodies `zona`, `cytoplasm`, `medium`, `pipette` and, where present, `plate`. Throws ModelError.
mpm::Model build_piercing(const PiercingSetup& setup);

}  // namespace zona::studies
