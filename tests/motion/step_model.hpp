// SPDX-License-Identifier: Apache-2.0
// A model of the step generator by its specification, clock by clock, without guard times: a queue
// of segments, the integration of the tick rate, Bresenham per axis.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>

#include "motion/segment.hpp"
#include "units/axes.hpp"

namespace motion_test {

__extension__ using Wide = __int128;

class StepModel {
 public:
  explicit StepModel(std::size_t depth) : depth_(depth) {}

  bool has_room() const { return queue_.size() < depth_; }
  bool idle() const { return !busy_ && queue_.empty(); }
  void push(const motion::Segment& segment) { queue_.push_back(segment); }

  // Called after every tick: ticks made of the line, its segment.
  std::function<void(std::uint32_t, const motion::Segment&)> on_tick;
  // Called at the first clock of a segment: the phase's rate in 2^-64 ticks per clock, and that
  // with which the segment before ended (0: from rest).
  std::function<void(const motion::Segment&, std::uint64_t rate_before)> on_segment;

  void clock() {
    ++clocks_;
    if (!busy_ && !load()) return;
    const std::uint64_t before = phase_;
    phase_ += static_cast<std::uint64_t>(rate_ >> 20);
    const bool tick = phase_ < before;
    rate_ += acceleration_;
    acceleration_ += segment_.jerk;
    if (rate_ <= 0) rate_ = 1, ++rates_below_zero_;
    ++busy_clocks_;
    if (tick) make_tick();
  }

  const units::PerAxis<std::int64_t>& positions() const { return positions_; }
  std::uint64_t clocks() const { return clocks_; }
  std::uint64_t busy_clocks() const { return busy_clocks_; }
  std::uint64_t underruns() const { return underruns_; }
  std::uint64_t rates_below_zero() const { return rates_below_zero_; }

 private:
  bool load() {
    if (queue_.empty()) return false;
    segment_ = queue_.front();
    queue_.pop_front();
    if (!segment_.continues_line) {
      line_ticks_done_ = 0;
      for (std::size_t i = 0; i < units::axis_count; ++i) errors_[i] = first_error(i);
    }
    if (on_segment) on_segment(segment_, resting_ ? 0 : static_cast<std::uint64_t>(rate_ >> 20));
    if (resting_) phase_ = 0;
    resting_ = false;
    rate_ = static_cast<Wide>(segment_.rate) << 20;
    acceleration_ = segment_.acceleration;
    ticks_left_ = segment_.ticks;
    busy_ = true;
    return true;
  }

  std::uint32_t first_error(std::size_t index) const {
    const auto axis = static_cast<units::Axis>(index);
    const std::uint32_t quarter = segment_.line_ticks / 4;
    if (segment_.start.behind.contains(axis)) return quarter;
    return segment_.line_ticks / 2 + (segment_.start.ahead.contains(axis) ? quarter : 0);
  }

  void make_tick() {
    for (std::size_t i = 0; i < units::axis_count; ++i) {
      const std::int64_t steps = segment_.steps[i];
      errors_[i] += static_cast<std::uint64_t>(steps < 0 ? -steps : steps);
      if (errors_[i] < segment_.line_ticks) continue;
      errors_[i] -= segment_.line_ticks;
      positions_[i] += steps < 0 ? -1 : 1;
    }
    ++line_ticks_done_;
    if (on_tick) on_tick(line_ticks_done_, segment_);
    if (--ticks_left_ > 0) return;
    busy_ = false;
    if (segment_.ends_motion && queue_.empty()) resting_ = true;
    if (!segment_.ends_motion && queue_.empty()) ++underruns_, resting_ = true;
  }

  std::size_t depth_;
  std::deque<motion::Segment> queue_;
  motion::Segment segment_{};
  bool busy_{};
  bool resting_{true};
  std::uint64_t phase_{};
  Wide rate_{};  // 2^-84
  std::int64_t acceleration_{};
  std::uint32_t ticks_left_{};
  std::uint32_t line_ticks_done_{};
  units::PerAxis<std::uint64_t> errors_{};
  units::PerAxis<std::int64_t> positions_{};
  std::uint64_t clocks_{};
  std::uint64_t busy_clocks_{};
  std::uint64_t underruns_{};
  std::uint64_t rates_below_zero_{};
};

}  // namespace motion_test
