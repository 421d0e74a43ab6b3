#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "mpm/files/frame_writer.h"
#include "mpm/step/solver.h"
#include "studies/input/configuration.h"
#include "studies/parameters/time_step.h"
#include "studies/run/progress.h"
#include "studies/simulation/checkpoints.h"

namespace spdlog {
class logger;
}

namespace zona::studies {

/// When a simulation writes what [s].
struct OutputPlan {
  double history_interval = 1e-7;
  double fields_interval = 4e-6;
  bool fields = true;
};

/// As the [output] table says; "auto" intervals are 1/500 and 1/20 of `end` [s].
OutputPlan output_plan(const Configuration& study, double end);

/// The most memory that this process has had so far [bytes].
long peak_memory();

/// What a simulation does besides stepping. Each is called from one thread.
struct MarchCalls {
  std::function<void()> after_step;     ///< after every step, before it is sampled
  std::function<void()> sample;         ///< writes the state as a row of the history
  std::function<std::string()> status;  ///< what the user should watch
  mpm::VisitState visit_state;          ///< shows what else changes with the steps, but the solver
};

/// Steps a solver to an end, samples it at even intervals, writes frames to fields.h5, stores
/// checkpoints and tells how far it is. The first instant is sampled and drawn at once, unless
/// there is a checkpoint to go on from.
class SolverMarch {
 public:
  /// What is passed and what the calls refer to must outlive the march. Files go to `directory`.
  SolverMarch(mpm::Solver& solver, double end, const OutputPlan& plan,
              const std::filesystem::path& directory, Checkpoints& checkpoints, spdlog::logger& log,
              MarchCalls calls);

  /// Tells the user from where the march goes on, if it does.
  void tell_start(Progress& progress) const;

  /// Returns at the end or when interrupted; the last state is stored, sampled and drawn. An error
  /// passes through after the last state is sampled. `part` of the stage of `progress` is this
  /// march.
  void run(Progress& progress, int part = 0);

  /// Adds points, steps, simulated_time, wall_seconds, output_seconds (of these, for samples,
  /// frames and checkpoints), peak_memory_bytes (of the process), point_steps_per_second.
  void add_cost(nlohmann::json& results) const;

 private:
  using Clock = std::chrono::steady_clock;

  void step();
  void visit_state(mpm::StateVisitor& visitor);
  void store();
  void sample();
  void write_frame();
  /// Whether an instant has come; a rounding error early counts.
  bool due(double instant) const;

  mpm::Solver& solver_;
  OutputPlan plan_;
  Checkpoints& checkpoints_;
  spdlog::logger& log_;
  MarchCalls calls_;
  double end_;
  std::optional<mpm::FrameWriter> frames_;
  double next_sample_ = 0, last_sample_ = -1;
  double next_frame_ = 0, last_frame_ = -1;
  Clock::time_point started_ = Clock::now();
  double seconds_before_ = 0;    ///< wall time until the checkpoint that this goes on from
  double stepping_seconds_ = 0;  ///< after the first steps, in which memory is touched first
  double output_seconds_ = 0;
};

}  // namespace zona::studies
