#include "studies/simulation/cost_forecast.h"

#include <fmt/format.h>

#include <chrono>

#include "mpm/points/errors.h"
#include "studies/parameters/time_step.h"
#include "studies/run/memory.h"
#include "studies/run/progress.h"
#include "studies/simulation/frames.h"

namespace zona::studies {

namespace {

/// Counts the bytes that a checkpoint of the visited state would hold.
class StateSize : public mpm::StateVisitor {
 public:
  using StateVisitor::visit;
  bool is_restoring() const override { return false; }
  void visit(const std::string&, double*, std::size_t count) override { bytes_ += 8.0 * count; }
  void visit(const std::string&, std::int32_t*, std::size_t count) override {
    bytes_ += 4.0 * count;
  }
  void visit(const std::string&, std::int64_t*, std::size_t count) override {
    bytes_ += 8.0 * count;
  }
  double bytes() const { return bytes_; }

 private:
  double bytes_ = 0;
};

double state_size(mpm::Solver& solver) {
  StateSize size;
  solver.visit_state(size);
  return size.bytes();
}

/// Positions and fields in single precision, as FrameWriter stores them.
double frame_size(const mpm::Solver& solver) {
  double values = 0;
  for (const mpm::PointCloud& cloud : point_clouds(solver)) {
    values += cloud.positions.size();
    for (const auto& field : cloud.fields) values += field.second.size();
  }
  for (const mpm::CellFields& cells : cell_fields(solver)) {
    for (const auto& field : cells.fields) values += field.second.size();
  }
  return 4 * values;
}

/// Mean time of a step [s]. The first steps, which touch memory for the first time, count only
/// where there is no time for others. `tried` becomes the time of all [s].
double seconds_per_step(mpm::Solver& solver, long steps, double& tried) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  double warm = 0;
  long done = 0, cold = 0;
  while (done < steps && (seconds() < 1 || done == 0)) {
    solver.step();
    ++done;
    if (seconds() > 0.2 && cold == 0 && done < steps) {
      warm = seconds();
      cold = done;
    }
  }
  tried = seconds();
  return done > cold ? (tried - warm) / static_cast<double>(done - cold)
                     : tried / static_cast<double>(done);
}

std::string size_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                     : fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string described(const CostForecast& cost, int threads) {
  std::string text = fmt::format(
      "Here, from trying it for {:.1g} s on {} thread{}: about {}, {} of memory, {} on disk",
      cost.tried, threads, threads == 1 ? "" : "s", duration_text(cost.seconds),
      size_text(cost.memory), size_text(cost.disk));
  const double available = available_memory();
  if (cost.memory > available) {
    text += fmt::format("\nwarning: only {} of memory are available", size_text(available));
  }
  return text + "\n";
}

}  // namespace

CostForecast forecast_cost(mpm::Model model, double step, double end, const OutputPlan& plan,
                           int threads) {
  const double before = allocated_memory();
  mpm::Solver solver(std::move(model), step, threads);
  const long steps = step_count(end, step);
  CostForecast cost{};
  cost.seconds = static_cast<double>(steps) * seconds_per_step(solver, steps, cost.tried);
  const double checkpoint = state_size(solver);
  // A checkpoint is assembled in memory, and copied once.
  cost.own_memory = allocated_memory() - before + 2 * checkpoint;
  cost.memory = peak_memory() + 2 * checkpoint;
  cost.frames = plan.fields ? static_cast<long>(end / plan.fields_interval) + 2 : 0;
  cost.disk = 2 * checkpoint + static_cast<double>(cost.frames) * frame_size(solver);
  return cost;
}

std::string forecast_text(const std::function<CostForecast()>& forecast, int threads) {
  try {
    return described(forecast(), threads);
  } catch (const mpm::StepError& error) {
    return fmt::format("warning: it fails within its first steps: {}\n", error.what());
  }
}

}  // namespace zona::studies
