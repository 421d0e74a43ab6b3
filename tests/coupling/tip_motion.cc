#include "coupling/tip_motion.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "coupling/prescribed_motion.h"
#include "coupling/tip_trace.h"

using namespace zona::coupling;
using Catch::Contains;
using zona::beam::TipHistory;
using zona::mpm::RigidMotion;
using Function = std::function<double(double)>;

namespace {

/// Unevenly sampled from t = 1 to 3; without velocities if no derivative is given.
TipHistory sampled(const Function& value, const Function& derivative, int intervals) {
  TipHistory history;
  for (int i = 0; i <= intervals; ++i) {
    const double x = static_cast<double>(i) / intervals;
    const double time = 1 + 2 * x + 0.2 * x * (1 - x);
    history.time.push_back(time);
    history.displacement.push_back(value(time));
    if (derivative) history.velocity.push_back(derivative(time));
  }
  return history;
}

double cubic(double t) {
  return 2 - 3 * t + 0.5 * t * t - 4 * t * t * t;
}
double cubic_slope(double t) {
  return -3 + t - 12 * t * t;
}
double parabola(double t) {
  return 1 + t - 7 * t * t;
}
double wave(double t) {
  return std::sin(4 * t);
}
double wave_slope(double t) {
  return 4 * std::cos(4 * t);
}

TipMotionOptions from_start() {
  TipMotionOptions options;
  options.start = 1.0;
  return options;
}

double along_x(const RigidMotion& motion, double time) {
  return motion(time).displacement.x();
}

/// Largest difference between the velocity and the fourth-order difference of the displacement.
double derivative_error(const RigidMotion& motion, double begin, double end, double step) {
  double largest = 0;
  for (int i = 0; i <= 100; ++i) {
    const double t = begin + 2 * step + (end - begin - 4 * step) * i / 100.0;
    const double difference = (8 * (along_x(motion, t + step) - along_x(motion, t - step)) -
                               (along_x(motion, t + 2 * step) - along_x(motion, t - 2 * step))) /
                              (12 * step);
    largest = std::max(largest, std::abs(difference - motion(t).velocity.x()));
  }
  return largest;
}

double interpolation_error(const Function& derivative, int intervals) {
  const TipMotion motion(sampled(wave, derivative, intervals), from_start());
  double largest = 0;
  for (double t = 0; t <= 2; t += 0.00137)
    largest = std::max(largest, std::abs(motion(t).displacement.x() - (wave(1 + t) - wave(1))));
  return largest;
}

}  // namespace

TEST_CASE("interpolation reproduces cubics with exact velocities, parabolas without any",
          "[motion]") {
  const TipMotion with(sampled(cubic, cubic_slope, 7), from_start());
  const TipMotion without(sampled(parabola, nullptr, 7), from_start());
  for (double t = 0; t <= 2; t += 0.01) {
    CHECK(with(t).displacement.x() == Approx(cubic(1 + t) - cubic(1)).margin(1e-12));
    CHECK(with(t).velocity.x() == Approx(cubic_slope(1 + t)).margin(1e-11));
    CHECK(without(t).displacement.x() == Approx(parabola(1 + t) - parabola(1)).margin(1e-12));
    CHECK(without(t).velocity.x() == Approx(1 - 14 * (1 + t)).margin(1e-11));
  }
}

TEST_CASE("interpolation is of order four with exact slopes, three without", "[motion]") {
  CHECK(std::log2(interpolation_error(wave_slope, 40) / interpolation_error(wave_slope, 80)) ==
        Approx(4).margin(0.1));
  CHECK(std::log2(interpolation_error(nullptr, 80) / interpolation_error(nullptr, 160)) ==
        Approx(3).margin(0.2));
}

TEST_CASE("displacement and velocity are continuous at the samples", "[motion]") {
  const TipHistory history = sampled(wave, wave_slope, 9);
  const TipMotion motion(history, from_start());
  for (std::size_t i = 1; i + 1 < history.time.size(); ++i) {
    const double t = history.time[i] - 1;
    const double gap = 1e-12;
    CHECK(motion(t - gap).displacement.x() ==
          Approx(motion(t + gap).displacement.x()).margin(1e-10));
    CHECK(motion(t - gap).velocity.x() == Approx(motion(t + gap).velocity.x()).margin(1e-9));
    CHECK(motion(t).velocity.x() == Approx(history.velocity[i]).margin(1e-9));
  }
}

TEST_CASE("the velocity is the derivative of the displacement, ramp or not", "[motion]") {
  for (const double ramp : {0.0, 0.3, 5.0}) {
    INFO(ramp);
    TipMotionOptions options = from_start();
    options.ramp = ramp;
    options.scale = -2;
    const TipHistory one_piece = sampled(cubic, cubic_slope, 2);
    CHECK(derivative_error(TipMotion(one_piece, options), 0, ramp > 1 ? 1 : 0.3, 1e-3) < 1e-8);

    SineMotion sine{2.0, 1.5};
    sine.ramp = ramp;
    CHECK(derivative_error(rigid_motion(sine), 0, 0.3, 1e-3) < 1e-8);
    CHECK(derivative_error(rigid_motion(sine), 0.3, 1.5, 1e-3) < 1e-8);

    TrianglePulse pulse{2.0, 0.6};
    pulse.ramp = ramp;
    CHECK(derivative_error(rigid_motion(pulse), 0, 0.3, 1e-3) < 1e-8);
    CHECK(derivative_error(rigid_motion(pulse), 0.3, 0.6, 1e-3) < 1e-8);
    CHECK(derivative_error(rigid_motion(pulse), 0.6, 2, 1e-3) == 0);
  }
}

TEST_CASE("a window starts without displacement and ends after its length", "[motion]") {
  TipMotionOptions options;
  options.start = 1.5;
  options.length = 0.5;
  options.scale = 3;
  options.axis = {0, 0, -2};
  const TipMotion motion(sampled(wave, wave_slope, 50), options);
  CHECK(motion.start() == 1.5);
  CHECK(motion.length() == 0.5);
  CHECK(motion(0).displacement.norm() == 0);
  CHECK(motion.initial_speed() == Approx(3 * wave_slope(1.5)).epsilon(1e-5));
  CHECK(motion(0.5).displacement.z() == Approx(-3 * (wave(2) - wave(1.5))).epsilon(1e-5));
  CHECK(motion(0.5 * (1 + 1e-10)).displacement == motion(0.5).displacement);  // rounded time
  CHECK_THROWS_WITH(motion(0.501), Contains("evaluated at 0.501 s") && Contains("0.5 s long"));
  CHECK_THROWS_AS(motion(-1e-3), std::out_of_range);
  CHECK_THROWS_AS(motion(std::nan("")), std::out_of_range);

  options.ramp = 0.1;
  const TipMotion ramped(sampled(wave, wave_slope, 50), options);
  CHECK(ramped(0).velocity.norm() == 0);
  CHECK(ramped(0.1).displacement == motion(0.1).displacement);
  CHECK(ramped(0.1).velocity == motion(0.1).velocity);
  CHECK(ramped(0.05).displacement.z() == Approx(motion(0.05).displacement.z() / 2));
}

TEST_CASE("the automatic window starts when the tip has moved by the fraction", "[motion]") {
  // At rest at 5 until t = 1.5, then down by (t - 1.5)^2, 2.25 at the end.
  const Function late = [](double t) { return 5 - (t > 1.5 ? (t - 1.5) * (t - 1.5) : 0); };
  const Function late_slope = [](double t) { return t > 1.5 ? -2 * (t - 1.5) : 0; };
  const TipHistory history = sampled(late, late_slope, 40);
  const double onset = 1.5 + std::sqrt(0.04 * 2.25);
  CHECK(onset_of_motion(history, 0.04) == Approx(onset).epsilon(1e-12));
  TipMotionOptions options;
  options.start_fraction = 0.04;
  const TipMotion motion(history, options);
  CHECK(motion.start() == Approx(onset).epsilon(1e-12));
  CHECK(motion.start() + motion.length() == Approx(3).epsilon(1e-15));
  CHECK(motion(motion.length()).displacement.x() == Approx(-0.96 * 2.25));
  CHECK_THROWS_WITH(onset_of_motion(history, 0), Contains("between 0 and 1"));
  CHECK_THROWS_WITH(onset_of_motion(sampled([](double) { return 1; }, nullptr, 5), 0.1),
                    Contains("never moves"));
}

TEST_CASE("two histories move the pipette together, from the onset of the tip's motion",
          "[motion]") {
  const auto late = [](double t) { return t < 2 ? 0 : (t - 2) * (t - 2); };
  const auto early = [](double t) { return t < 1.5 ? 0 : 3 * (t - 1.5) * (t - 1.5); };
  const TipHistory slow = sampled(late, nullptr, 400), fast = sampled(early, nullptr, 400);
  TipMotionOptions options;
  options.axis = {0, 2, 0};
  options.scale = 0.5;
  options.ramp = 0.2;
  const TipMotion both(slow, options, {fast, {-1, 0, 0}});
  // The largest departure is that at the end, 1 across and 6.75 along; the slow one still rests
  // when a hundredth of it is passed.
  CHECK(both.start() == Approx(1.5 + std::sqrt(0.01 * std::hypot(1, 6.75) / 3)).epsilon(1e-5));
  // However little the fast one moves, what begins is the motion of both: no jump to 1.5.
  TipHistory faint = fast;
  for (double& displacement : faint.displacement) displacement *= 1e-6;
  CHECK(TipMotion(slow, options, {faint, {-1, 0, 0}}).start() ==
        Approx(onset_of_motion(slow, options.start_fraction)).epsilon(1e-9));
  CHECK(both.axis() == Eigen::Vector3d(0, 1, 0));
  CHECK(both.length() == Approx(3 - both.start()));
  // The sum of the two motions alone, over the same window.
  options.start = both.start();
  const TipMotion across(slow, options);
  options.axis = {-1, 0, 0};
  const TipMotion along(fast, options);
  for (const double time : {0., 0.1, 0.5, 1.3}) {
    const auto state = both(time), first = across(time), second = along(time);
    CHECK(state.displacement == first.displacement + second.displacement);
    CHECK(state.velocity == first.velocity + second.velocity);
  }
  CHECK(both.initial_speed() == Approx(along.initial_speed()));
  CHECK(derivative_error(both, 0.3, 1.2, 1e-3) < 1e-2);
  TipHistory shorter = fast;
  for (auto* values : {&shorter.time, &shorter.displacement}) values->resize(200);
  options.length = 1.4;
  CHECK_THROWS_WITH(TipMotion(slow, options, {shorter, {-1, 0, 0}}), Contains("spans only"));
  CHECK_THROWS_WITH(TipMotion(slow, options, {fast, {0, 0, 0}}), Contains("no direction"));
}

TEST_CASE("windows and options out of range are refused", "[motion]") {
  const TipHistory history = sampled(wave, wave_slope, 20);
  const auto refused = [&](auto change, const char* message) {
    TipMotionOptions options = from_start();
    change(options);
    CHECK_THROWS_WITH(TipMotion(history, options), Contains(message));
  };
  refused([](auto& o) { o.start = 0.5; }, "the history spans only 1 s to 3 s");
  refused([](auto& o) { o.start = 3.0; }, "the history spans only");
  refused([](auto& o) { o.start = std::nan(""); }, "the history spans only");
  refused([](auto& o) { o.length = 2.1; }, "from 1 s, 2.1 s long, ends at 3.1 s");
  refused([](auto& o) { o.length = 0.0; }, "window length 0 s must be positive");
  refused([](auto& o) { o.axis.setZero(); }, "no direction");
  refused([](auto& o) { o.scale = INFINITY; }, "scale inf is not finite");
  refused([](auto& o) { o.ramp = -1; }, "ramp -1 s must not be negative");
  TipHistory broken = history;
  broken.displacement.pop_back();
  CHECK_THROWS_AS(TipMotion(broken, from_start()), TraceError);
}

TEST_CASE("the prescribed sine is that of the dissertation", "[motion]") {
  const RigidMotion motion = rigid_motion(SineMotion{13.5e-6, 100e-6, {0, 3, 0}});
  CHECK(motion(0).displacement.norm() == 0);
  CHECK(motion(0).velocity.y() == Approx(0.848).epsilon(1e-3));
  CHECK(motion(25e-6).displacement.y() == Approx(13.5e-6));
  CHECK(motion(75e-6).displacement.y() == Approx(-13.5e-6));
  CHECK_THROWS_AS(motion(-1e-9), std::out_of_range);
  CHECK_THROWS_WITH(rigid_motion(SineMotion{1e-6, 0}), Contains("period 0 s must be positive"));
  CHECK_THROWS_WITH(rigid_motion(SineMotion{NAN, 1}), Contains("amplitude nan"));
}

TEST_CASE("the triangular pulse rises, falls and rests", "[motion]") {
  const RigidMotion motion = rigid_motion(TrianglePulse{18e-6, 60e-6});
  CHECK(motion(0).velocity.x() == Approx(0.6));
  CHECK(motion(15e-6).displacement.x() == Approx(9e-6));
  CHECK(motion(30e-6).displacement.x() == Approx(18e-6));
  CHECK(motion(30e-6).velocity.x() == Approx(-0.6));
  CHECK(motion(45e-6).displacement.x() == Approx(9e-6));
  CHECK(motion(60e-6).displacement.x() == 0);
  CHECK(motion(60e-6).velocity.x() == 0);
  CHECK(motion(1).displacement.x() == 0);
  CHECK_THROWS_WITH(rigid_motion(TrianglePulse{1e-6, -1}), Contains("duration -1 s"));
}
