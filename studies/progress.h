#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace zona::studies {

/// Tells the user how far a study is: one live line on a terminal, otherwise a line every ten
/// seconds or ten percent, or nothing at all. Cheap enough to call every step, from one thread.
///
///     progress.start("mercury", end);
///     ... progress.update(time, points * steps, fmt::format("{} failed", failed)); ...
///     progress.finish();
class Progress {
 public:
  enum class Mode { quiet, lines, live };
  using Clock = std::function<double()>;  ///< seconds, steady

  /// The mode that suits the standard error stream.
  static Mode suitable_mode(bool quiet);

  Progress(Mode mode, std::ostream& stream);
  Progress(Mode mode, std::ostream& stream, Clock clock);
  /// Ends a live line that was not finished, so that later messages start on their own line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins a stage that ends when `update` gets `total` (simulated seconds, runs, anything).
  void start(const std::string& label, double total);
  /// `point_steps` counts the work done in the stage so far (points times steps; zero when that
  /// means nothing); `quantities` is whatever the user should watch.
  void update(double done, double point_steps = 0, const std::string& quantities = "");
  /// Ends the stage; shows its last state.
  void finish();

 private:
  std::string line() const;
  void show();

  Mode mode_;
  std::ostream& stream_;
  Clock clock_;
  bool active_ = false;
  std::string label_;
  std::string quantities_;
  double total_ = 0;
  double done_ = 0;
  double point_steps_ = 0;
  double started_ = 0;
  double shown_at_ = 0;
  double shown_fraction_ = 0;
};

/// "12 s", "3:05 min", "2:15 h".
std::string duration_text(double seconds);

}  // namespace zona::studies
