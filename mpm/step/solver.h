#pragma once

#include <string>
#include <vector>

#include "mpm/conditions/boundary.h"
#include "mpm/conditions/damping.h"
#include "mpm/conditions/load.h"
#include "mpm/pressure/implicit_pressure.h"
#include "mpm/step/brick_schedule.h"
#include "mpm/step/critical_step.h"
#include "mpm/step/stage_clock.h"

/// Libraries to simulate piezo-ICSI: a beam, a material point method, and their coupling. SI units
/// throughout. Equation, figure and table numbers are those of the dissertation, "the source".
namespace zona {}

/// The material point method: grids, bodies of points, materials, membranes, loads, the step, and
/// files. Independent of beams, deal.II and oocytes.
namespace zona::mpm {

/// Options of the scheme; the defaults are those of the source.
struct Numerics {
  double pic = 0;                    ///< fraction of PIC in the points' velocity; 0 is (3.37), FLIP
  double damping = 0;                ///< local non-viscous damping of the nodal forces, 0 to 1
  bool implicit_pressure = false;    ///< of the fluids: the step does not wait for sound
  double pressure_tolerance = 1e-3;  ///< residual of the implicit pressure, see ImplicitPressure
};

/// Initial state and conditions of a simulation.
struct Model {
  BackgroundGrid grid;                                ///< on which momentum is balanced
  std::vector<Body> bodies;                           ///< all share the grid
  FaceConditions faces{};                             ///< all free
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< [m/s^2]
  std::vector<BodyForce> forces{};                    ///< on points of bodies
  std::vector<SurfacePressure> pressures{};           ///< on membranes
  std::vector<HeldNodes> held{};                      ///< nodes with prescribed motion
  Numerics numerics{};                                ///< options of the scheme
};

/// Explicit material point method, MUSL variant, the algorithm of section 3.2; the pressure of
/// fluids may be implicit. Between steps the nodes hold the sums scattered by the points,
/// (3.30)-(3.32).
///
/// Results are the same to the last bit for any number of threads: bricks of one colour share no
/// node, and every sum over points or bricks has a fixed order.
class Solver {
 public:
  /// `step` [s] must not exceed the critical step. Throws ModelError, and PointError for points
  /// outside the grid.
  Solver(Model model, double step, int threads = 1);

  /// Takes one step, (3.30)-(3.42). Throws PointError if a point leaves the grid or its state
  /// becomes invalid, StepError if an implicit pressure does not converge; the solver cannot
  /// continue then.
  void step();

  /// Visits all state between two steps that the model does not contain. A restored solver of the
  /// same model and step continues to the same bits, with any number of threads.
  void visit_state(StateVisitor& visitor);

  double time() const { return steps_ * dt_; }                       ///< since the start [s]
  double step_size() const { return dt_; }                           ///< [s]
  long steps() const { return steps_; }                              ///< number of steps taken
  int threads() const { return threads_; }                           ///< number of threads
  long point_count() const;                                          ///< of all bodies
  const BackgroundGrid& grid() const { return model_.grid; }         ///< with the scattered sums
  const std::vector<Body>& bodies() const { return model_.bodies; }  ///< in the order of the model
  const FaceConditions& faces() const { return model_.faces; }       ///< of the grid
  /// The body with this name. Throws ModelError if there is none.
  const Body& body(const std::string& name) const;
  /// Held nodes in the order of the model, with the reactions of the last step.
  const std::vector<HeldNodes>& held() const { return model_.held; }
  /// The implicit pressure; null if it is explicit.
  const ImplicitPressure* implicit_pressure() const { return pressure_ ? &*pressure_ : nullptr; }
  /// Wall time of all steps so far [s].
  const StageSeconds& stage_seconds() const { return stage_seconds_; }

 private:
  void prepare(Body& body);
  void prescribe_motion();
  void add_loads();
  void advance_momentum();
  void solve_pressure();
  void hold_moved_nodes();
  void gather_and_map_back();
  void finish_nodes();
  void update_unfused();
  void update_membranes();
  void index_moved_points();
  void update_and_scatter();
  void scatter();
  void sort_points();
  /// Estimated cost of each brick, in points.
  std::vector<double> estimated_costs() const;

  void record_invalid_points(const Body& body, const std::vector<int>& points);
  void throw_if_invalid_points();
  [[noreturn]] void fail_at(const Body& body, int point, const std::string& what) const;

  Model model_;
  Loads loads_;
  std::vector<std::vector<int>> held_nodes_;  ///< per entry of Model::held
  std::optional<ImplicitPressure> pressure_;  ///< empty if explicit
  LocalDamping damping_;
  double dt_;
  int threads_;
  BrickSchedule schedule_;
  std::int64_t steps_ = 0;
  StageSeconds stage_seconds_{};
  std::vector<std::vector<int>> driven_nodes_;  ///< per body; empty without Drive::nodes
  struct InvalidPoint {
    int body;
    int id;
  };
  std::vector<InvalidPoint> invalid_points_;
};

}  // namespace zona::mpm
