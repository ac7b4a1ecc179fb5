// SPDX-License-Identifier: Apache-2.0
// Random runs: acts as software on the reference model and records the stimuli.
#include "tests/motion_reference/random_stimuli.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "registers/step_generator_registers.hpp"

namespace motion_reference {
namespace {

namespace registers = ::registers::step_generator;

struct Write {
  std::uint32_t address{};
  std::uint32_t value{};
};

class Player {
 public:
  Player(std::uint32_t seed, std::size_t segments) : random_(seed), segments_left_(segments) {
    write_settings(seed);
  }

  RandomRun play() {
    // The last write takes effect a clock later, and the last pulse has a width.
    constexpr int rest_clocks = 300, clocks_to_take_effect = 10;
    for (int rest = 0; rest < rest_clocks; ++rest) {
      if (segments_left_ > 0 || !writes_.empty() || !run_.reference.idle()) rest = 0;
      if (run_.reference.now() >= next_inputs_) change_inputs();
      const bool may_write = rest < rest_clocks - clocks_to_take_effect;
      if (may_write && run_.reference.now() >= next_write_) use_the_bus();
      clock();
    }
    run_.clocks = run_.reference.now();
    return std::move(run_);
  }

 private:
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }
  bool chance(std::uint32_t percent) { return below(100) < percent; }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }

  template <class Register>
  void put(const Register& value) {
    writes_.push_back({Register::address, value.encode()});
  }
  template <class Register>
  void put(std::size_t index, const Register& value) {
    writes_.push_back({Register::address_of(index), value.encode()});
  }

  void write_settings(std::uint32_t seed) {
    longest_guard_ = seed % 3 == 0 ? 1 : seed % 16 == 1 ? 120 : 12;
    both_edges_ = seed % 4 == 0;
    for (std::size_t axis = 0; axis < axes; ++axis) put_guards(axis);
    put(registers::MotorEnable{all_motors});
    put(registers::RateFloor{std::uint32_t{1} << (21 + below(7))});
    put(registers::OverrideSlope{random_slope()});
    put(registers::BrakeSlope{random_slope()});
    if (seed % 5 == 0) put(registers::Watchdog{2000 + below(30000)});
    put(registers::Control{.run = true});
  }

  void put_guards(std::size_t axis) {
    const auto guard = [this] {
      return longest_guard_ == 1 ? below(2) : 1 + below(longest_guard_);
    };
    put(axis, registers::PulseGuard{
                  .high = guard(), .low = guard(), .both_edges = both_edges_ && chance(50)});
    put(axis, registers::DirectionGuard{.setup = guard(), .hold = guard()});
  }

  std::uint32_t random_slope() { return static_cast<std::uint32_t>(random_()) >> below(13); }

  // Mostly as asked, otherwise a hold, any scale worth waiting for, or one that cannot be reached.
  void put_override() {
    constexpr std::uint32_t one = 65536;
    override_ = chance(30) ? one : chance(40) ? 0 : one / 10 + below(4 * one - one / 10);
    put(registers::Override{override_});
  }

  void note(const Stimulus& stimulus) {
    run_.stimuli.push_back(stimulus);
    run_.reference.apply(stimulus);
  }

  void clock() {
    run_.reference.clock();
    const Pins pins = run_.reference.pins();
    if (pins == last_pins_) return;
    run_.edges.push_back({run_.reference.now(), pins});
    last_pins_ = pins;
  }

  // End stops mostly open, now and then closed for some clocks; rarely the emergency stop. The
  // start comes with them, or when a segment waits for it.
  void change_inputs() {
    const std::uint32_t start = chance(50) ? 0x200u : 0;
    const std::uint32_t value = start | (inputs_closed_ ? 0
                                         : chance(5)    ? 0x100u
                                         : chance(30)   ? below(256)
                                                        : 1u << below(8));
    inputs_closed_ = !inputs_closed_;
    note({run_.reference.now(), Stimulus::Kind::inputs, 0, value});
    next_inputs_ = run_.reference.now() + (inputs_closed_ ? 1 + below(200) : 5000 + below(80000));
    if (chance(5) || (inputs_bounce_ = chance(inputs_bounce_ ? 80 : 10))) {
      next_inputs_ = run_.reference.now() + 1 + below(20);
    }
  }

  void use_the_bus() {
    if (writes_.empty()) decide();
    if (writes_.empty()) return;
    note({run_.reference.now(), Stimulus::Kind::write, writes_.front().address,
          writes_.front().value});
    writes_.pop_front();
    next_write_ = run_.reference.now() + 2 + (chance(20) ? below(4) : 0);
  }

  void decide() {
    if (run_.reference.waiting() && chance(10)) {
      put(registers::Command{.start = true});
    } else if (override_ == 0 && chance(segments_left_ == 0 ? 50 : 3)) {
      put_override();
    } else if (run_.reference.stopped() && chance(20)) {
      put(registers::Command{.acknowledge_stop = true, .clear_errors = chance(50)});
    } else if (run_.reference.motors() != all_motors && chance(10)) {
      put(registers::MotorEnable{chance(80) ? all_motors : below(all_motors + 1)});
    } else if (segments_left_ == 0) {
      if (!running_) put(registers::Control{.run = running_ = true});
      next_write_ = run_.reference.now() + 50;
    } else if (chance(1)) {
      something_rare();
    } else if (run_.reference.level() >= queue_depth && !chance(2)) {
      if (!running_) put(registers::Control{.run = running_ = true});
      next_write_ = run_.reference.now() + 1 + below(1000);
    } else {
      put_segment();
      if (chance(70)) put(registers::Command{.feed_watchdog = true});
      if (chance(5)) next_write_ = run_.reference.now() + below(1500);
    }
  }

  void something_rare() {
    switch (below(12)) {
      case 0:
        put(registers::Command{.flush = true, .snapshot = true});
        break;
      case 1:
        put(registers::Command{.stop = true, .acknowledge_stop = chance(30)});
        break;
      case 2:
        put(registers::Command{.snapshot = true, .clear_errors = true});
        break;
      case 3:
        put(below(axes), registers::Position{static_cast<std::int32_t>(random_())});
        break;
      case 4:
        put(registers::Control{.run = running_ = false});
        break;
      case 5:
        if (chance(30)) put(registers::BrakeSlope{chance(30) ? 0 : random_slope()});
        put(registers::Command{
            .acknowledge_stop = chance(20), .brake = true, .feed_watchdog = chance(50)});
        break;
      case 6:
      case 7:
        put_override();
        break;
      case 8:
        put_guards(below(axes));
        break;
      case 9:
        put(registers::RateFloor{chance(30) ? 0 : std::uint32_t{1} << (21 + below(7))});
        break;
      case 10:
        put(registers::MotorEnable{below(all_motors + 1)});
        if (chance(50)) put(registers::Command{.positions_known = true});
        break;
      default:
        put(registers::Control{.run = running_ = true});
        break;
    }
  }

  void put_segment() {
    --segments_left_;
    const bool continues = line_left_ > 0 && chance(70);
    const std::uint32_t ahead = below(16);
    // Only by mistake the same axes; where a line is continued neither counts.
    const std::uint32_t behind = continues || chance(1) ? below(16) : below(16) & ~ahead;
    put(registers::SegmentFlags{.backward = below(256),
                                .continues_line = continues,
                                .ends_motion = chance(20),
                                .stop_on_change = chance(30),
                                .stop_on_release = chance(10),
                                .stop_brakes = chance(50),
                                .waits_for_start = chance(3),
                                .stop_mask = chance(20) ? below(256) & below(256) : 0,
                                .ahead = ahead,
                                .behind = behind});
    if (!continues) put_line();
    const std::uint32_t ticks = line_left_ == 0 ? 1
                                : chance(50)    ? line_left_
                                                : 1 + below(line_left_);
    line_left_ -= std::min(ticks, line_left_);
    put(registers::SegmentTicks{ticks});
    put_course(ticks);
    // A word is missing, or one too many.
    if (chance(1)) writes_.erase(writes_.end() - 1 - below(6));
    if (chance(1)) put(below(axes), registers::SegmentSteps{below(1000)});
    put(registers::SegmentCommit{});
  }

  void put_line() {
    const std::uint32_t line_ticks = chance(20) ? 1 + below(3) : 1 + below(1u << (1 + below(8)));
    put(registers::SegmentLineTicks{line_ticks});
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::uint32_t steps = chance(30) ? 0 : chance(40) ? line_ticks : below(line_ticks + 1);
      put(axis, registers::SegmentSteps{chance(99) || chance(90) ? steps : line_ticks + 1});
    }
    line_left_ = line_ticks;
  }

  // In ticks per clock; not so slow that the segment takes more than some thousand clocks.
  double random_rate(double ticks) {
    if (chance(25)) return 0.5;
    return std::min(0.5, std::max(std::exp2(uniform(-9, -1)), ticks / 1000));
  }

  void put_course(double ticks) {
    const double rate = random_rate(ticks);
    const double end_rate = chance(40) ? rate : random_rate(ticks);
    const double clocks = 2 * ticks / (rate + end_rate);
    const double acceleration = (end_rate - rate) / clocks * (chance(10) ? uniform(-3, 3) : 1);
    const double jerk = chance(50) ? 0 : uniform(-1, 1) * std::abs(acceleration) / clocks;
    put_wide(registers::SegmentRate{fixed(rate, 64)});
    const bool any = chance(5);
    const auto number = [&](double value) {
      return static_cast<std::int64_t>(any ? any_word() : fixed(value, 84));
    };
    put_wide(registers::SegmentAcceleration{number(acceleration)});
    put_wide(registers::SegmentJerk{number(jerk)});
  }

  std::uint64_t any_word() {
    const std::uint64_t high = random_();
    return high << 32u | random_();
  }

  // As a number of 2^-`places`, two's complement; what does not fit becomes the largest.
  std::uint64_t fixed(double value, int places) {
    const double scaled = std::ldexp(value, places);
    if (places == 64) return std::min(static_cast<std::uint64_t>(scaled), std::uint64_t{1} << 63u);
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(std::clamp(scaled, -9.2e18, 9.2e18)));
  }

  template <class Wide>
  void put_wide(const Wide& value) {
    put(value.low());
    put(value.high());
  }

  static constexpr std::uint32_t all_motors = (1u << axes) - 1;

  std::mt19937 random_;
  std::uint32_t longest_guard_ = 1;
  bool both_edges_ = false;
  std::size_t segments_left_;
  RandomRun run_;
  Pins last_pins_{};
  std::deque<Write> writes_;
  std::uint64_t next_write_ = 4;
  std::uint64_t next_inputs_ = 3000;
  bool inputs_closed_ = false, inputs_bounce_ = false;
  bool running_ = true;
  std::uint32_t override_ = 65536;
  std::uint32_t line_left_ = 0;
};

}  // namespace

RandomRun random_run(std::uint32_t seed, std::size_t segments) {
  return Player(seed, segments).play();
}

}  // namespace motion_reference
