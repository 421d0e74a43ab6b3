#pragma once

#include <string>
#include <vector>

#include "mpm/boundary.h"
#include "mpm/brick_schedule.h"
#include "mpm/critical_step.h"
#include "mpm/damping.h"
#include "mpm/load.h"
#include "mpm/stage_clock.h"

namespace zona::mpm {

/// Choices of the scheme; as in the source unless set.
struct Numerics {
  double pic = 0;      ///< fraction of PIC in the points' velocity; 0 is (3.37), FLIP
  double damping = 0;  ///< local non-viscous damping of the nodal forces, 0 to 1
};

/// Everything a simulation starts from.
struct Model {
  BackgroundGrid grid;
  std::vector<Body> bodies;
  FaceConditions faces{};                             ///< all free
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< [m/s^2]
  std::vector<BodyForce> forces{};
  std::vector<SurfacePressure> pressures{};
  std::vector<HeldNodes> held{};
  Numerics numerics{};
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

  void step();

  /// Everything between two steps that the model does not tell. A solver of the same model and
  /// step, restored, goes on to the same bits with any number of threads.
  void visit_state(StateVisitor& visitor);

  double time() const { return steps_ * dt_; }
  double step_size() const { return dt_; }
  long steps() const { return steps_; }
  int threads() const { return threads_; }
  long point_count() const;
  const BackgroundGrid& grid() const { return model_.grid; }
  const std::vector<Body>& bodies() const { return model_.bodies; }
  const FaceConditions& faces() const { return model_.faces; }
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
