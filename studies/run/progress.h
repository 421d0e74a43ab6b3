#pragma once

#include <functional>
#include <mutex>
#include <ostream>
#include <string>
#include <vector>

namespace zona::studies {

/// Tells the user how far a study is: one live line on a terminal, otherwise a line every ten
/// seconds or ten percent, or nothing at all. Cheap enough to call every step. A stage may have
/// several parts that run side by side; each part is reported by one thread.
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

  /// From now on also tells `publish` every two seconds how far the stage is, in every mode.
  void publish_to(std::function<void(const std::string& line)> publish);
  /// From now on also tells `publish` every two seconds the fraction of the stage that is done.
  void publish_fraction_to(std::function<void(double fraction)> publish);

  /// Begins a stage whose parts end when `update` gets `total` (simulated seconds, runs, anything).
  void start(const std::string& label, double total, int parts = 1);
  /// Work of a part that was done before this program began; it does not count in speed and time
  /// left.
  void begin_at(double done, double point_steps, int part = 0);
  /// `point_steps` counts the work done in the part so far (points times steps; zero when that
  /// means nothing); `quantities` is whatever the user should watch.
  void update(double done, double point_steps = 0, const std::string& quantities = "",
              int part = 0);
  /// A line of its own, in every mode but quiet.
  void say(const std::string& message);
  /// Ends the stage; shows its last state.
  void finish();

 private:
  struct Part {
    double done = 0;
    double point_steps = 0;
    std::string quantities;
    double done_before = 0;
    double point_steps_before = 0;
  };

  /// Fraction of the stage that is done.
  double fraction(double Part::*done = &Part::done) const;
  double point_steps() const;
  std::string line() const;
  void show();

  Mode mode_;
  std::ostream& stream_;
  Clock clock_;
  std::function<void(const std::string&)> publish_;
  std::function<void(double)> publish_fraction_;
  bool active_ = false;
  std::string label_;
  double total_ = 0;
  std::vector<Part> parts_;
  std::mutex mutex_;  ///< of the parts and of what is shown while a stage runs
  double started_ = 0;
  double shown_at_ = 0;
  double published_at_ = 0;
  double shown_fraction_ = 0;
};

/// "12 s", "3:05 min", "2:15 h".
std::string duration_text(double seconds);

}  // namespace zona::studies
