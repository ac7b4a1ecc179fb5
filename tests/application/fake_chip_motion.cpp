// SPDX-License-Identifier: Apache-2.0
// The step generator of the fake chip: motion line by line.
#include "tests/application/fake_chip.hpp"

#include <algorithm>
#include <cmath>

#include "registers/step_generator_registers.hpp"

namespace application_test {
namespace {

namespace steps = registers::step_generator;

double clocks_of(double ticks, double rate, double acceleration) {
  const double end = std::sqrt(std::max(rate * rate + 2 * acceleration * ticks, 1e-18));
  return 2 * ticks / (rate + end);
}

}  // namespace

void FakeChip::command(std::uint32_t value) {
  const auto wanted = steps::Command::decode(value);
  if (wanted.flush) queue_.clear();
  if (wanted.stop) stop(0, true);
  if (wanted.acknowledge_stop) stopped_ = false;
  if (wanted.feed_watchdog) ++motion_watchdog_feeds;
}

void FakeChip::stop(std::uint32_t end_stops, bool software) {
  queue_.clear();
  moving_ = false;
  stopped_ = true;
  stop_end_stops_ = end_stops;
  stopped_by_software_ = software;
}

void FakeChip::stop_by_watchdog() {
  stop(0, false);
  stopped_by_watchdog_ = true;
}

void FakeChip::commit() {
  const auto flags = steps::SegmentFlags::decode(word(steps::SegmentFlags::address));
  const auto wide = [this](std::uint32_t low, std::uint32_t high) {
    return (std::uint64_t{word(high)} << 32) | word(low);
  };
  Segment segment;
  segment.continues = flags.continues_line;
  segment.ends_motion = flags.ends_motion;
  segment.stop_mask = flags.stop_mask;
  segment.line_ticks = word(steps::SegmentLineTicks::address);
  segment.ticks = word(steps::SegmentTicks::address);
  segment.rate = std::ldexp(
      static_cast<double>(wide(steps::SegmentRateLow::address, steps::SegmentRateHigh::address)),
      -64);
  segment.acceleration = std::ldexp(
      static_cast<double>(static_cast<std::int64_t>(
          wide(steps::SegmentAccelerationLow::address, steps::SegmentAccelerationHigh::address))),
      -84);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::int64_t count = word(steps::SegmentSteps::address_of(axis));
    segment.steps[axis] = (flags.backward >> axis & 1u) != 0 ? -count : count;
  }
  queue_.push_back(segment);
}

void FakeChip::advance_motion(std::uint32_t clocks) {
  double left = std::ldexp(clocks, -16) * word(steps::Override::address);
  while (left > 0 && !stopped_) {
    if (!moving_) {
      if (queue_.empty()) return;
      if (!queue_.front().continues) line_tick_ = 0;
      line_ = queue_.front();
      queue_.pop_front();
      segment_end_tick_ = line_tick_ + line_.ticks;
      segment_time_ = clocks_of(static_cast<double>(line_.ticks), line_.rate, line_.acceleration);
      segment_time_left_ = segment_time_;
      moving_ = true;
    }
    if (segment_time_left_ > left) {
      segment_time_left_ -= left;
      const double ticks_left =
          static_cast<double>(line_.ticks) * segment_time_left_ / segment_time_;
      walk_to(segment_end_tick_ - static_cast<std::int64_t>(std::ceil(ticks_left)));
      return;
    }
    left -= segment_time_left_;
    walk_to(segment_end_tick_);
    if (stopped_) return;
    moving_ = false;
    if (queue_.empty() && !line_.ends_motion) ++underruns;
  }
}

// Of the line, since its begin.
std::int64_t FakeChip::steps_until(std::size_t axis, std::int64_t line_tick) const {
  return line_.steps[axis] * line_tick / line_.line_ticks;
}

void FakeChip::walk_to(std::int64_t line_tick) {
  if (line_tick <= line_tick_) return;
  const std::int64_t last = tick_of_stop(line_tick);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::int64_t steps = steps_until(axis, last) - steps_until(axis, line_tick_);
    position[axis] += static_cast<std::int32_t>(steps);
    mechanical[axis] += steps;
  }
  line_tick_ = last;
  if (const std::uint32_t hit = line_.stop_mask & end_stops(); hit != 0) stop(hit, false);
}

// The first tick, at least one from here, after which an end stop that ends the line is closed; at
// most `last_tick`. An axis moves to one side only: towards its end stop it closes once, and away
// from it the first tick is the one at which it is most closed.
std::int64_t FakeChip::tick_of_stop(std::int64_t last_tick) const {
  if (line_.stop_mask == 0 || !end_stops_work) return last_tick;
  if ((line_.stop_mask & end_stops_stuck) != 0) return line_tick_ + 1;
  std::int64_t first = last_tick;
  for (std::size_t input = 0; input <= probe_input; ++input) {
    if ((line_.stop_mask >> input & 1u) == 0) continue;
    const auto closed = [&](std::int64_t tick) {
      auto there = mechanical;
      for (std::size_t axis = 0; axis < there.size(); ++axis) {
        there[axis] += steps_until(axis, tick) - steps_until(axis, line_tick_);
      }
      return input == probe_input ? probe_triggers(there) : end_stop_closed(input, there[input]);
    };
    if (closed(line_tick_ + 1)) return line_tick_ + 1;
    if (!closed(first)) continue;
    std::int64_t open = line_tick_ + 1;
    while (first - open > 1) {
      const std::int64_t middle = open + (first - open) / 2;
      (closed(middle) ? first : open) = middle;
    }
  }
  return first;
}

}  // namespace application_test
