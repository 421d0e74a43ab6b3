#pragma once

#include "mpm/bodies/lattice.h"
#include "mpm/step/solver.h"

namespace zona::studies {

/// The oocyte, the medium around it, the holding plate and the injection pipette of 5.4, SI units.
/// The x axis runs from the plate through the egg into the pipette; y is the lateral direction.
struct PiercingSetup {
  double cell;
  double domain;  ///< edge of the cubic grid; rounded up to whole cells

  struct Zona {
    double diameter;
    int level;  ///< subdivisions of the icosahedron
    mpm::MembraneProperties membrane;
    mpm::MembraneLaw law;
    bool objective;
  } zona;

  struct FluidRegion {
    mpm::FluidProperties fluid;
    int points_per_cell;  ///< a cube number
  };
  FluidRegion cytoplasm;
  FluidRegion medium;

  struct Pipette {
    double outer_diameter;
    double inner_diameter;
    double tip_length;
    std::array<int, 3> points;  ///< radial, circumferential, axial
    double density;             ///< glass and fill, spread over the glass
    mpm::Drive drive;
    mpm::RigidMotion motion;
  } pipette;

  struct Plate {
    bool present;
    double side;
    int thickness_cells;
    double density;
  } plate;

  mpm::Interpolation interpolation;
  bool average_volume_strain;  ///< of the fluids
  mpm::Numerics numerics;

  mpm::FaceConditions faces;

  static mpm::FaceConditions all_faces(mpm::FaceCondition condition) {
    return {condition, condition, condition, condition, condition, condition};
  }
};

/// Places in the grid of a setup [m].
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
