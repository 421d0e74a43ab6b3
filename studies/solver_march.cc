#include "studies/solver_march.h"

#include <sys/resource.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/frames.h"
#include "studies/interrupt.h"

namespace zona::studies {

namespace {

/// Steps that the rate of stepping leaves out.
constexpr long warm_up = 50;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of this process so far [bytes].
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

}  // namespace

OutputPlan output_plan(const Configuration& study, double end) {
  const auto interval = [&](const char* key, double automatic) {
    return study.is_auto(key) ? automatic : study.quantity(key);
  };
  return {interval("output.history_interval", end / 500),
          interval("output.fields_interval", end / 20), study.boolean("output.fields")};
}

long step_count(double end, double step) {
  return static_cast<long>(std::floor(end / step + 1e-6));
}

SolverMarch::SolverMarch(mpm::Solver& solver, double end, const OutputPlan& plan,
                         const std::filesystem::path& directory, MarchCalls calls)
    : solver_(solver), plan_(plan), calls_(std::move(calls)), end_(end) {
  if (plan.fields) frames_.emplace(directory.string());
  sample();
  write_frame();
}

void SolverMarch::run(Progress& progress, int part) {
  const double points = static_cast<double>(solver_.point_count());
  const long steps = step_count(end_, solver_.step_size());
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
  frames_->add_frame(solver_.time(), draw(solver_));
  output_seconds_ += seconds_since(start);
}

void SolverMarch::add_cost(nlohmann::json& results) const {
  const long timed = solver_.steps() - warm_up;
  const double rate = timed > 0 ? static_cast<double>(timed) / stepping_seconds_ : 0;
  results["points"] = solver_.point_count();
  results["steps"] = solver_.steps();
  results["simulated_time"] = solver_.time();
  results["wall_seconds"] = seconds_since(started_);
  results["output_seconds"] = output_seconds_;
  results["peak_memory_bytes"] = peak_memory();
  results["point_steps_per_second"] = rate * static_cast<double>(solver_.point_count());
}

}  // namespace zona::studies
