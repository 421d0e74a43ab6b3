#include "studies/run/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace zona::studies {

namespace {

double steady_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::size_t terminal_width() {
  winsize size = {};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

std::string bar(double fraction) {
  constexpr int width = 20;
  const int filled = static_cast<int>(fraction * width);
  return "[" + std::string(filled, '#') + std::string(width - filled, '.') + "]";
}

}  // namespace

Progress::Mode Progress::suitable_mode(bool quiet) {
  if (quiet) return Mode::quiet;
  return isatty(STDERR_FILENO) != 0 ? Mode::live : Mode::lines;
}

Progress::Progress(Mode mode, std::ostream& stream) : Progress(mode, stream, steady_seconds) {}

Progress::Progress(Mode mode, std::ostream& stream, Clock clock)
    : mode_(mode), stream_(stream), clock_(std::move(clock)) {}

Progress::~Progress() {
  if (active_ && mode_ == Mode::live) stream_ << std::endl;
}

void Progress::publish_to(std::function<void(const std::string& line)> publish) {
  publish_ = std::move(publish);
}

void Progress::publish_fraction_to(std::function<void(double fraction)> publish) {
  publish_fraction_ = std::move(publish);
}

void Progress::start(const std::string& label, double total, int parts) {
  if (active_) finish();
  active_ = true;
  label_ = label;
  total_ = total;
  parts_.assign(parts, {});
  shown_fraction_ = 0;
  started_ = shown_at_ = published_at_ = clock_();
}

void Progress::begin_at(double done, double point_steps, int part) {
  const std::lock_guard lock(mutex_);
  parts_[part] = {done, point_steps, "", done, point_steps};
}

void Progress::update(double done, double point_steps, const std::string& quantities, int part) {
  const std::lock_guard lock(mutex_);
  if (!active_) return;
  Part& updated = parts_[part];
  updated.done = done;
  updated.point_steps = point_steps;
  updated.quantities = quantities;
  const double now = clock_();
  if (now - published_at_ >= 2) {
    published_at_ = now;
    if (publish_) publish_(line());
    if (publish_fraction_) publish_fraction_(fraction());
  }
  if (mode_ == Mode::quiet) return;
  const double waited = now - shown_at_;
  const bool next_tenth = fraction() >= shown_fraction_ + 0.1 - 1e-12 && waited >= 0.2;
  const bool due = mode_ == Mode::live ? waited >= 0.2 : waited >= 10 || next_tenth;
  if (!due) return;
  shown_at_ = now;
  shown_fraction_ = std::floor(fraction() * 10 + 1e-9) / 10;
  show();
}

void Progress::say(const std::string& message) {
  const std::lock_guard lock(mutex_);
  if (mode_ == Mode::quiet) return;
  stream_ << (mode_ == Mode::live ? "\r\x1b[K" : "") << message << std::endl;
}

void Progress::finish() {
  if (active_ && mode_ != Mode::quiet) {
    const bool shown_already = mode_ == Mode::lines && shown_fraction_ >= 1;
    if (!shown_already) show();
    if (mode_ == Mode::live) stream_ << std::endl;
  }
  active_ = false;
}

double Progress::fraction(double Part::*done) const {
  double sum = 0;
  for (const auto& part : parts_) sum += part.*done;
  const double total = total_ * static_cast<double>(parts_.size());
  return total > 0 ? std::clamp(sum / total, 0.0, 1.0) : 0;
}

double Progress::point_steps() const {
  double sum = 0;
  for (const auto& part : parts_) sum += part.point_steps - part.point_steps_before;
  return sum;
}

std::string Progress::line() const {
  const double elapsed = clock_() - started_;
  std::string text = fmt::format("{} {} {:3.0f} %", label_, bar(fraction()), fraction() * 100);
  const double done_now = fraction() - fraction(&Part::done_before);
  if (fraction() >= 1) {
    text += fmt::format("  took {}", duration_text(elapsed));
  } else if (done_now > 0) {
    text += fmt::format("  {} left", duration_text(elapsed * (1 - fraction()) / done_now));
  }
  if (point_steps() > 0 && elapsed > 0) {
    text += fmt::format("  {:.3g} M point-steps/s", point_steps() / elapsed * 1e-6);
  }
  std::string quantities;
  for (const auto& part : parts_) {
    if (!part.quantities.empty()) quantities += (quantities.empty() ? "" : "; ") + part.quantities;
  }
  return quantities.empty() ? text : text + "  " + quantities;
}

void Progress::show() {
  if (mode_ == Mode::live) {
    // A line that wraps could not be overwritten, so it ends before the terminal does.
    stream_ << '\r' << line().substr(0, terminal_width() - 1) << "\x1b[K" << std::flush;
  } else {
    stream_ << line() << std::endl;
  }
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::min(std::round(std::max(seconds, 0.0)), 1e9));
  if (whole < 100) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

}  // namespace zona::studies
