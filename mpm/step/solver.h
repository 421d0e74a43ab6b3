#pragma once

#include <string>
#include <vector>

#include "mpm/conditions/boundary.h"
#include "mpm/conditions/damping.h"
#include "mpm/conditions/load.h"
#include "mpm/step/brick_schedule.h"
#include "mpm/step/critical_step.h"
#include "mpm/step/stage_clock.h"

/// Libraries to simulate piezo-ICSI: a beam, a material point method, and what joins them. SI units
/// throughout. Equation, figure and table numbers are those of the dissertation, "the source".
namespace zona {}

/// The material point method: grids, bodies of points, materials, membranes, loads, the step, and
/// files. Knows nothing of beams, deal.II or oocytes.
namespace zona::mpm {

/// Choices of the scheme; as in the source unless set.
struct Numerics {
  double pic = 0;      ///< fraction of PIC in the points' velocity; 0 is (3.37), FLIP
  double damping = 0;  ///< local non-viscous damping of the nodal forces, 0 to 1
};

/// Everything a simulation starts from.
struct Model {
  BackgroundGrid grid;                                ///< where momentum is balanced
  std::vector<Body> bodies;                           ///< all share the grid
  FaceConditions faces{};                             ///< all free
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< [m/s^2]
  std::vector<BodyForce> forces{};                    ///< on points of bodies
  std::vector<SurfacePressure> pressures{};           ///< on membranes
  std::vector<HeldNodes> held{};                      ///< nodes that move as prescribed
  Numerics numerics{};                                ///< choices of the scheme
};

/// Explicit material point method, MUSL variant, the algorithm of section 3.2. Between steps the
/// nodes hold what the points have scattered, (3.30)-(3.32).
///
/// Results are the same to the last bit for any number of threads: bricks of one colour share no
/// node, and every sum over points or bricks is taken in one order.
class Solver {
 public:
  /// `step` in seconds; refused when it is above the critical step. Throws ModelError, and
  /// PointError for points outside the grid.
  Solver(Model model, double step, int threads = 1);

  /// One step, (3.30)-(3.42). Throws PointError when a point leaves the grid or its state lost its
  /// meaning; the solver cannot go on then.
  void step();

  /// Everything between two steps that the model does not tell. A solver of the same model and
  /// step, restored, goes on to the same bits with any number of threads.
  void visit_state(StateVisitor& visitor);

  double time() const { return steps_ * dt_; }                ///< since the start [s]
  double step_size() const { return dt_; }                    ///< [s]
  long steps() const { return steps_; }                       ///< taken so far
  int threads() const { return threads_; }                    ///< that compute
  long point_count() const;                                   ///< of all bodies
  const BackgroundGrid& grid() const { return model_.grid; }  ///< between steps: what was scattered
  const std::vector<Body>& bodies() const { return model_.bodies; }  ///< in the order of the model
  const FaceConditions& faces() const { return model_.faces; }       ///< of the grid
  /// The body of that name. Throws ModelError if there is none.
  const Body& body(const std::string& name) const;
  /// Held nodes in the order of the model, with the reactions of the last step.
  const std::vector<HeldNodes>& held() const { return model_.held; }
  /// Wall time of all steps so far [s].
  const StageSeconds& stage_seconds() const { return stage_seconds_; }

 private:
  void prescribe_motion();
  void add_loads();
  void advance_momentum();
  void gather_and_map_back();
  void finish_nodes();
  void update_what_cannot_wait();
  void update_membranes();
  void index_moved_points();
  void update_and_scatter();
  void scatter();
  void store_as_walked();
  /// Of each brick, in points.
  std::vector<double> estimated_costs() const;

  void note_bad_points(const Body& body, const std::vector<int>& points);
  void refuse_bad_points();
  [[noreturn]] void fail_at(const Body& body, int point, const std::string& what) const;

  Model model_;
  Loads loads_;
  std::vector<std::vector<int>> held_nodes_;  ///< of each entry of Model::held
  LocalDamping damping_;
  double dt_;
  int threads_;
  BrickSchedule schedule_;
  std::int64_t steps_ = 0;
  StageSeconds stage_seconds_{};
  std::vector<std::vector<int>> driven_nodes_;  ///< per body, of those that drive nodes
  struct BadPoint {
    int body;
    int id;
  };
  std::vector<BadPoint> bad_points_;
};

}  // namespace zona::mpm
