#include "studies/simulation/simulation.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "studies/parameters/time_step.h"
#include "studies/run/interrupt.h"
#include "studies/run/memory.h"
#include "studies/simulation/frames.h"

namespace zona::studies {

namespace {

/// First steps, which do not count in the rate of stepping.
constexpr long warm_up = 50;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Simulation::Simulation(SimulatedModel model, const SimulationContext& context)
    : context_(context),
      end_(model.end),
      solver_(std::move(model.model), model.step, context.threads),
      checkpoints_(context.directory, context.checkpoints),
      measures_(context.study, solver_, model.origin, model.end, context.directory,
                checkpoints_.is_resumed()) {}

void Simulation::start(Observer& observer) {
  observer_ = &observer;
  columns_ = observer.columns();
  measures_.add_columns(columns_);
  history_.emplace(context_.directory / "history.csv", headings(columns_),
                   checkpoints_.is_resumed());
  started_ = Clock::now();
  if (checkpoints_.is_resumed()) {
    restore();
  } else {
    start_anew();
  }
  report_start();
}

void Simulation::start_anew() {
  if (context_.output.fields) frames_.emplace(context_.directory.string());
  sample();
  write_frame();
  measures_.write_due();
}

void Simulation::restore() {
  checkpoints_.restore([this](mpm::StateVisitor& visitor) { visit_state(visitor); });
  if (context_.output.fields)
    frames_ = mpm::FrameWriter::resume(context_.directory.string(), last_frame_);
}

void Simulation::report_start() const {
  if (!checkpoints_.warning().empty()) {
    context_.progress.say(checkpoints_.warning());
    context_.log.warn(checkpoints_.warning());
  }
  if (!checkpoints_.is_resumed()) return;
  const std::string start =
      fmt::format("goes on after {:.4g} us, step {} of {}", solver_.time() * 1e6, solver_.steps(),
                  step_count(end_, solver_.step_size()));
  context_.progress.say(start);
  context_.log.info(start);
}

void Simulation::visit_state(mpm::StateVisitor& visitor) {
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
  history_->visit_state(visitor);
  measures_.visit_state(visitor);
  observer_->visit_state(visitor);
}

void Simulation::run() {
  const double points = static_cast<double>(solver_.point_count());
  const long steps = step_count(end_, solver_.step_size());
  const auto point_steps = [&] { return points * static_cast<double>(solver_.steps()); };
  context_.progress.begin_at(solver_.time(), point_steps(), context_.part);
  try {
    while (solver_.steps() < steps && !Interrupt::requested()) {
      step();
      context_.progress.update(solver_.time(), point_steps(), observer_->status(), context_.part);
    }
  } catch (const std::runtime_error&) {
    sample();
    throw;
  }
  store();  // before the samples that only a stop here makes
  sample();
  write_frame();
}

void Simulation::step() {
  const auto start = Clock::now();
  solver_.step();
  if (solver_.steps() > warm_up) stepping_seconds_ += seconds_since(start);
  observer_->after_step();
  measures_.write_due();
  if (is_due(next_sample_)) sample();
  if (is_due(next_frame_)) write_frame();
  if (checkpoints_.is_due(solver_.steps())) store();
}

bool Simulation::is_due(double instant) const {
  return solver_.time() >= instant - 1e-6 * solver_.step_size();
}

void Simulation::store() {
  const auto start = Clock::now();
  const bool stored = checkpoints_.store(
      solver_.steps(), [this](mpm::StateVisitor& visitor) { visit_state(visitor); });
  const double seconds = seconds_since(start);
  if (stored) {
    context_.log.info(fmt::format("checkpoint after step {}, {:.2f} s", solver_.steps(), seconds));
  }
  output_seconds_ += seconds;
}

void Simulation::sample() {
  if (solver_.time() == last_sample_) return;
  const auto start = Clock::now();
  last_sample_ = solver_.time();
  while (is_due(next_sample_)) next_sample_ += context_.output.history_interval;
  observer_->measure();
  measures_.sample();
  history_->add(row_of(columns_));
  output_seconds_ += seconds_since(start);
}

void Simulation::write_frame() {
  if (!frames_ || solver_.time() == last_frame_) return;
  const auto start = Clock::now();
  last_frame_ = solver_.time();
  while (is_due(next_frame_)) next_frame_ += context_.output.fields_interval;
  frames_->add_frame(solver_.time(), point_clouds(solver_), cell_fields(solver_));
  const double seconds = seconds_since(start);
  context_.log.debug(fmt::format("frame {} at {:.6g} us, {:.2f} s", frames_->frame_count() - 1,
                                 solver_.time() * 1e6, seconds));
  output_seconds_ += seconds;
}

nlohmann::json Simulation::results() const {
  nlohmann::json results;
  observer_->add_results(results);
  measures_.add_results(results);
  add_cost(results);
  return results;
}

void Simulation::add_cost(nlohmann::json& results) const {
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
