#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "mpm/files/frame_writer.h"
#include "mpm/step/solver.h"
#include "studies/input/configuration.h"
#include "studies/measures/measures.h"
#include "studies/run/history_file.h"
#include "studies/run/progress.h"
#include "studies/simulation/checkpoints.h"
#include "studies/simulation/observer.h"
#include "studies/simulation/output_plan.h"

namespace spdlog {
class logger;
}

namespace zona::studies {

/// A model, and for how long it is simulated.
struct SimulatedModel {
  mpm::Model model;
  double step = 0;  ///< [s]
  double end = 0;   ///< [s]
  /// Places in [[probe]], [[profile]] and [[section]] count from here [m].
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

/// Surroundings of a simulation, which may be one of several that run side by side.
struct SimulationContext {
  const Configuration& study;  ///< for [[probe]], [[profile]] and [[section]]
  OutputPlan output;
  CheckpointPlan checkpoints;
  std::filesystem::path directory;  ///< exists; for the files
  int threads = 1;
  spdlog::logger& log;
  Progress& progress;  ///< in a stage that lasts until the end of the simulation
  int part = 0;        ///< of that stage
};

/// A solver in time. Steps it to an end, samples it at even intervals into history.csv, writes
/// probes, profiles, frames (fields.h5) and checkpoints, and reports progress.
///
///     Simulation simulation(std::move(model), context);
///     MyObserver observer(simulation.solver());
///     simulation.start(observer);
///     simulation.run();
class Simulation {
 public:
  /// Finds the checkpoint that a resumed run continues from. The context must outlive this object.
  /// Throws CheckpointError when none of the checkpoints can be used.
  Simulation(SimulatedModel model, const SimulationContext& context);

  mpm::Solver& solver() { return solver_; }

  /// Samples and draws the first instant, or restores the checkpoint. The observer must outlive
  /// this object.
  void start(Observer& observer);

  /// Returns at the end or when interrupted; the last state is stored, sampled and drawn. An error
  /// passes through after the last state is sampled. Call `start` first.
  void run();

  /// Results of the observer and the probes, and: points, steps, simulated_time, wall_seconds,
  /// output_seconds (of these, for samples, frames and checkpoints), peak_memory_bytes (of the
  /// process), point_steps_per_second.
  nlohmann::json results() const;

 private:
  using Clock = std::chrono::steady_clock;

  void start_anew();
  void restore();
  void report_start() const;
  void step();
  void visit_state(mpm::StateVisitor& visitor);
  void store();
  void sample();
  void write_frame();
  /// The instant has come, give or take a rounding error.
  bool is_due(double instant) const;
  void add_cost(nlohmann::json& results) const;

  const SimulationContext& context_;
  double end_;
  mpm::Solver solver_;
  Checkpoints checkpoints_;
  Measures measures_;
  Observer* observer_ = nullptr;
  std::vector<ValueColumn<>> columns_;
  std::optional<HistoryFile> history_;
  std::optional<mpm::FrameWriter> frames_;
  double next_sample_ = 0, last_sample_ = -1;
  double next_frame_ = 0, last_frame_ = -1;
  Clock::time_point started_ = Clock::now();
  double seconds_before_ = 0;    ///< wall time until the checkpoint that this run continues from
  double stepping_seconds_ = 0;  ///< without the first steps, which touch memory for the first time
  double output_seconds_ = 0;
};

}  // namespace zona::studies
