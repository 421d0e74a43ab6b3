// The tip of a pipette, set ringing by a piezo pulse, pushes a small plate against water. How much
// momentum does the water get?
//
// The beam gives the motion of the tip, zona::coupling makes it the motion of a rigid body, and the
// material point method computes what that body does: the chain from pulse to fluid. All quantities
// are in SI units.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "beam/motion/support_motion.h"
#include "beam/pipette/fluid.h"
#include "beam/pipette/pipette.h"
#include "beam/system/beam_system.h"
#include "beam/time/integrate.h"
#include "coupling/tip_motion.h"
#include "mpm/bodies/lattice.h"
#include "mpm/step/solver.h"

using namespace zona;

namespace {

beam::TipHistory ringing_tip() {
  beam::Pipette pipette;
  pipette.fill_density = beam::named_fluid("mercury").density;
  // Water feels the velocity of the tip, which has more of the high modes in it than the
  // displacement has. They take more elements than the default; the highest are damped, as glass
  // does.
  pipette.elements = 80;
  pipette.damping_beta = 1e-7;
  return beam::integrate(beam::cantilever(pipette), beam::triangular_pulse(17.9e-6, 120e-6),
                         {1e-3, 0.3e-6}, beam::Modal{});
}

// A column of cells along x: empty, plate, water up to an absorbing face. The cells are large
// against the motion, because the face absorbs fully only while the water's points stand where they
// began.
constexpr double cell = 1e-3;
constexpr double area = cell * cell;
constexpr double plate_begins = 2 * cell;
constexpr double water_begins = 4 * cell;
const mpm::FluidProperties water{1000, {4, 6.13e8}, 0, 0, {}};

mpm::MaterialPoints points_between(const mpm::BackgroundGrid& grid, double low, double high,
                                   double density) {
  const mpm::Lattice lattice = mpm::fill_cells(grid, {2, 1, 1}, [&](const Eigen::Vector3d& place) {
    return place.x() > low && place.x() < high;
  });
  std::vector<double> mass;
  for (const double volume : lattice.volumes) mass.push_back(density * volume);
  return mpm::make_points(lattice.places, mass);
}

mpm::Model column(mpm::RigidMotion motion) {
  using mpm::FaceCondition;
  const mpm::BackgroundGrid grid(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(cell),
                                 {60, 1, 1});
  mpm::Model model{grid, {}};
  model.faces = {FaceCondition::free,   FaceCondition::absorbing, FaceCondition::roller,
                 FaceCondition::roller, FaceCondition::roller,    FaceCondition::roller};

  // The nodes between plate and water move with the mean of both by mass. A heavy plate makes them
  // follow the plate; its motion is prescribed, so nothing else depends on its mass.
  const double plate_density = 1e6;
  auto plate = points_between(grid, plate_begins, water_begins, plate_density);
  mpm::Prescribed rigid(plate, plate_density, std::move(motion));
  model.bodies.push_back({"plate", std::move(plate), std::move(rigid), {}});

  auto points = points_between(grid, water_begins, grid.upper_corner().x(), water.density);
  mpm::Fluid fluid(water, points.size());
  model.bodies.push_back({"water", std::move(points), std::move(fluid), {}});
  return model;
}

}  // namespace

int main() {
  // The tip rests for a while: the pulse has to travel along the pipette first. Unless told
  // otherwise the window starts when the tip has moved by a hundredth of its largest displacement.
  coupling::TipMotionOptions options;
  options.length = 300e-6;
  const coupling::TipMotion motion(ringing_tip(), options);
  std::printf("The tip starts %.1f us after the pulse, at %.3g m/s.\n", motion.start() * 1e6,
              motion.initial_speed());

  const double sound = water.state.sound_speed(water.pressure, water.density);
  mpm::Solver solver(column(motion), 0.4 * cell / sound);
  const auto& plate = solver.body("plate");
  double plate_mass = 0;
  for (const double m : plate.points.mass) plate_mass += m;

  // Nothing comes back from the absorbing face, so the water presses with rho c v on the plate, and
  // what it has got is rho c A times how far the plate has moved.
  std::puts("time [us]  plate [um]  momentum of the water [uN s]   rho c A u [uN s]");
  double supplied = 0;
  double largest = 0;
  double worst = 0;
  for (int sample = 1; sample <= 10; ++sample) {
    while (solver.time() < (sample - 0.5) / 10 * motion.length()) {
      solver.step();
      // `reaction` is the force that keeps the plate in its motion: the water's and its own
      // inertia.
      supplied += solver.step_size() * plate.prescribed()->reaction.x();
    }
    const mpm::RigidState& now = plate.prescribed()->next;
    // The plate starts with the speed of the tip; what it has gained since is not the water's.
    const double momentum = supplied - plate_mass * (now.velocity.x() - motion.initial_speed());
    const double exact = water.density * sound * area * now.displacement.x();
    std::printf("%9.1f %11.3f %17.4f %27.4f\n", solver.time() * 1e6, now.displacement.x() * 1e6,
                momentum * 1e6, exact * 1e6);
    largest = std::max(largest, std::abs(exact));
    worst = std::max(worst, std::abs(momentum - exact));
  }

  // The plate's front is a cell wide, and the absorbing face sends a little back, the more the
  // water's points have moved: a hundredth of a cell here.
  if (worst < 0.02 * largest) return 0;
  std::printf("The momentum is off by %.2g of its largest value, more than it should be.\n",
              worst / largest);
  return 1;
}
