// SPDX-License-Identifier: Apache-2.0
// The resonance test: planner and shaping drive a mode of vibration round a corner, step by step,
// and the ringing behind the corner is compared with the unshaped one.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "motion/planner.hpp"
#include "motion/shaping.hpp"
#include "sim/plants/vibration.hpp"
#include "tests/motion/machine.hpp"

namespace plants_test {
namespace {

constexpr double clock_hz = 50e6;

// Executes segments as the step generator does, but in double; the mode hangs on X.
class Printer {
 public:
  Printer(double hertz, double damping) : mode_(hertz, damping) {}

  void execute(const motion::Segment& segment) {
    if (!segment.continues_line) error_ = segment.line_ticks / 2;
    double rate = std::ldexp(static_cast<double>(segment.rate), -64) * clock_hz;
    const double acceleration =
        std::ldexp(static_cast<double>(segment.acceleration), -84) * clock_hz * clock_hz;
    const double begin = seconds_;
    for (std::uint32_t tick = 1; tick <= segment.ticks; ++tick) {
      const double speed = std::sqrt(std::max(rate * rate + 2 * acceleration * tick, 0.0));
      seconds_ = begin + 2 * tick / (rate + speed);
      error_ += std::abs(segment.steps[0]);
      if (error_ >= static_cast<std::int64_t>(segment.line_ticks)) {
        error_ -= segment.line_ticks;
        position_ += segment.steps[0] > 0 ? 1 : -1;
        mode_.move_to(seconds_, position_);
      }
    }
    mode_.advance(seconds_);
  }

  // Its amplitude now, in steps.
  double ringing() const { return mode_.amplitude(); }
  double seconds() const { return seconds_; }
  double position() const { return position_; }

 private:
  plants::Vibration mode_;
  std::int64_t error_ = 0;
  double position_ = 0;
  double seconds_ = 0;
};

// 60 mm along X, a corner, 60 mm along Y. The ringing in steps as soon as X stands for good: after
// `corner` seconds without shaping, and later by the shaper's length with it. Steps are fine, so
// that those of rounding excite less than what is measured.
struct Corner {
  double ringing, seconds;
};
Corner ringing_behind_corner(const motion::Shaper& shaper, double hertz, double damping,
                             double corner) {
  const motion::StepTiming timing = motion_test::timing(50'000'000);
  motion::Limits limits = motion_test::mendel();
  limits.print_acceleration = limits.travel_acceleration =
      units::MicrometersPerSecondSquared(3'000'000);
  for (const auto axis : {units::Axis::x, units::Axis::y}) {
    limits.of(axis).steps_per_meter = units::StepsPerMeter(1'600'000);
  }
  motion::Planner planner(limits, timing);
  motion::Shaping shaping;
  shaping.set_timing(timing);
  shaping.set_limits(limits);
  EXPECT_TRUE(shaping.configure({.shapers = {shaper, shaper}}));
  for (const auto& target :
       {motion_test::at(60'000'000, 0, 0, 0), motion_test::at(60'000'000, 60'000'000, 0, 0)}) {
    EXPECT_TRUE(
        planner.append({.target = target, .feedrate = units::MicrometersPerSecond(100'000)}, {}));
  }
  planner.flush();
  const motion::Impulses impulses = motion::impulses_of(shaper, timing.clock);
  const double last = impulses.list[impulses.count - 1].delay;
  const double later =
      shaping.active() ? shaping.delay_clocks() + last - impulses.mean + shaping.slot_clocks() : 0;
  Printer printer(hertz, damping);
  while (!planner.empty() || !shaping.at_rest() || !planner.between_lines()) {
    const units::Microseconds now(static_cast<std::int64_t>(printer.seconds() * 1e6));
    std::optional<motion::Segment> segment;
    if (shaping.active()) {
      segment = shaping.next_segment(planner, now, false).segment;
    } else {
      segment = planner.next_segment(now);
    }
    if (!segment) continue;
    printer.execute(*segment);
    const bool arrived = printer.position() == 60 * 1600;
    if (arrived && printer.seconds() >= corner + later / clock_hz) {
      return {printer.ringing(), printer.seconds()};
    }
  }
  ADD_FAILURE() << "X does not arrive";
  return {};
}

double part_left(const motion::Shaper& shaper, double hertz, double damping) {
  const Corner unshaped = ringing_behind_corner({}, hertz, damping, 0);
  return ringing_behind_corner(shaper, hertz, damping, unshaped.seconds).ringing / unshaped.ringing;
}

TEST(ringing, falls_to_a_twentieth_with_each_shaper_at_its_frequency) {
  for (std::size_t type = 1; type < motion::shaper_type_count; ++type) {
    for (const std::uint32_t millihertz : {25'000u, 40'000u, 61'000u}) {
      const motion::Shaper shaper{
          .type = static_cast<motion::ShaperType>(type), .millihertz = millihertz, .damping = 1000};
      const double left = part_left(shaper, millihertz / 1e3, 0.1);
      RecordProperty(std::string(motion::shaper_names[type]) + std::to_string(millihertz),
                     std::to_string(left));
      std::printf("%s at %g Hz: %.4f left\n", motion::shaper_names[type].data(), millihertz / 1e3,
                  left);
      EXPECT_LE(left, 0.05);
    }
  }
}

// The measurement can fail.
TEST(ringing, stays_with_a_wrong_frequency) {
  for (const auto type : {motion::ShaperType::zv, motion::ShaperType::zvd, motion::ShaperType::mzv,
                          motion::ShaperType::ei}) {
    const motion::Shaper shaper{.type = type, .millihertz = 60'000, .damping = 1000};
    EXPECT_GT(part_left(shaper, 30, 0.1), 0.1) << static_cast<int>(type);
  }
}

}  // namespace
}  // namespace plants_test
