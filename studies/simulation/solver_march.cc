#include "studies/simulation/solver_march.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/run/interrupt.h"
#include "studies/simulation/frames.h"

namespace zona::studies {

namespace {

/// Steps that the rate of stepping leaves out.
constexpr long warm_up = 50;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

OutputPlan output_plan(const Configuration& study, double end) {
  const auto interval = [&](const char* key, double automatic) {
    return study.is_auto(key) ? automatic : study.quantity(key);
  };
  return {interval("output.history_interval", end / 500),
          interval("output.fields_interval", end / 20), study.boolean("output.fields")};
}

SolverMarch::SolverMarch(mpm::Solver& solver, double end, const OutputPlan& plan,
                         const std::filesystem::path& directory, Checkpoints& checkpoints,
                         spdlog::logger& log, MarchCalls calls)
    : solver_(solver),
      plan_(plan),
      checkpoints_(checkpoints),
      log_(log),
      calls_(std::move(calls)),
      end_(end) {
  if (checkpoints.is_resumed()) {
    checkpoints.restore([this](mpm::StateVisitor& visitor) { visit_state(visitor); });
    if (plan.fields) frames_ = mpm::FrameWriter::resume(directory.string(), last_frame_);
    return;
  }
  if (plan.fields) frames_.emplace(directory.string());
  sample();
  write_frame();
}

void SolverMarch::visit_state(mpm::StateVisitor& visitor) {
  double seconds = seconds_before_ + seconds_since(started_);
  visitor.visit("march/seconds", seconds);
  if (visitor.is_restoring()) seconds_before_ = seconds;
  visitor.visit("march/stepping_seconds", stepping_seconds_);
  visitor.visit("march/output_seconds", output_seconds_);
  visitor.visit("march/next_sample", next_sample_);
  visitor.visit("march/last_sample", last_sample_);
  visitor.visit("march/next_frame", next_frame_);
  visitor.visit("march/last_frame", last_frame_);
  solver_.visit_state(visitor);
  calls_.visit_state(visitor);
}

void SolverMarch::store() {
  const auto start = Clock::now();
  const bool stored = checkpoints_.store(
      solver_.steps(), [this](mpm::StateVisitor& visitor) { visit_state(visitor); });
  const double seconds = seconds_since(start);
  if (stored) log_.info("checkpoint after step {}, {:.2f} s", solver_.steps(), seconds);
  output_seconds_ += seconds;
}

void SolverMarch::tell_start(Progress& progress) const {
  if (!checkpoints_.warning().empty()) {
    progress.say(checkpoints_.warning());
    log_.warn(checkpoints_.warning());
  }
  if (!checkpoints_.is_resumed()) return;
  const std::string start =
      fmt::format("goes on after {:.4g} us, step {} of {}", solver_.time() * 1e6, solver_.steps(),
                  step_count(end_, solver_.step_size()));
  progress.say(start);
  log_.info(start);
}

void SolverMarch::run(Progress& progress, int part) {
  const double points = static_cast<double>(solver_.point_count());
  const long steps = step_count(end_, solver_.step_size());
  progress.begin_at(solver_.time(), points * static_cast<double>(solver_.steps()), part);
  try {
    while (solver_.steps() < steps && !Interrupt::requested()) {
      step();
      progress.update(solver_.time(), points * static_cast<double>(solver_.steps()),
                      calls_.status(), part);
    }
  } catch (const std::runtime_error&) {
    sample();
    throw;
  }
  store();  // before the samples that only a stop here makes
  sample();
  write_frame();
}

void SolverMarch::step() {
  const auto start = Clock::now();
  solver_.step();
  if (solver_.steps() > warm_up) stepping_seconds_ += seconds_since(start);
  calls_.after_step();
  if (due(next_sample_)) sample();
  if (due(next_frame_)) write_frame();
  if (checkpoints_.is_due(solver_.steps())) store();
}

bool SolverMarch::due(double instant) const {
  return solver_.time() >= instant - 1e-6 * solver_.step_size();
}

void SolverMarch::sample() {
  if (solver_.time() == last_sample_) return;
  const auto start = Clock::now();
  last_sample_ = solver_.time();
  while (due(next_sample_)) next_sample_ += plan_.history_interval;
  calls_.sample();
  output_seconds_ += seconds_since(start);
}

void SolverMarch::write_frame() {
  if (!frames_ || solver_.time() == last_frame_) return;
  const auto start = Clock::now();
  last_frame_ = solver_.time();
  while (due(next_frame_)) next_frame_ += plan_.fields_interval;
  frames_->add_frame(solver_.time(), draw(solver_), draw_cells(solver_));
  const double seconds = seconds_since(start);
  log_.debug("frame {} at {:.6g} us, {:.2f} s", frames_->frame_count() - 1, solver_.time() * 1e6,
             seconds);
  output_seconds_ += seconds;
}

void SolverMarch::add_cost(nlohmann::json& results) const {
  const long timed = solver_.steps() - warm_up;
  const double rate = timed > 0 ? static_cast<double>(timed) / stepping_seconds_ : 0;
  results["points"] = solver_.point_count();
  results["steps"] = solver_.steps();
  results["simulated_time"] = solver_.time();
  results["wall_seconds"] = seconds_before_ + seconds_since(started_);
  results["output_seconds"] = output_seconds_;
  results["peak_memory_bytes"] = peak_memory();
  results["point_steps_per_second"] = rate * static_cast<double>(solver_.point_count());
}

}  // namespace zona::studies
