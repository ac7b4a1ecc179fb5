// SPDX-License-Identifier: Apache-2.0
// Slots of time: what is planned at the end of each, and the segment that goes there.
#include "motion/shaping.hpp"

#include <algorithm>
#include <bit>

#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace motion {

namespace {

constexpr std::size_t extruder = units::index_of(units::Axis::e);
constexpr int least_slot_bits = 14;
constexpr std::uint32_t slots_per_second = 500;  // at least

int slot_bits_of(units::Hertz clock) {
  return std::max(static_cast<int>(std::bit_width(clock.count() / slots_per_second)) - 1,
                  least_slot_bits);
}

}  // namespace

void Shaping::set_timing(const StepTiming& timing) {
  clock_ = timing.clock;
  slot_bits_ = slot_bits_of(clock_);
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    // The generator makes at most a tick every second clock.
    most_rates_[i] = std::min(timing.max_step_rate[i].count(), clock_.count() / 2);
  }
}

void Shaping::set_limits(const Limits& limits) {
  const AxisLimits& axis = limits.axes[extruder];
  const std::uint64_t rate = static_cast<std::uint64_t>(axis.steps_per_meter.count()) *
                             static_cast<std::uint32_t>(axis.max_speed.count()) / 1'000'000;
  extruder_rate_ = static_cast<std::uint32_t>(std::min<std::uint64_t>(rate, 0xFFFF'FFFF));
  limit_steps();
}

void Shaping::limit_steps() {
  const auto in_slot = [this](std::uint32_t rate) {
    const std::uint64_t steps = (std::uint64_t{rate} << slot_bits_) / clock_.count();
    return static_cast<std::int32_t>(std::min<std::uint64_t>(steps, 0x3FFF'FFFF));
  };
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    most_steps_[i] = std::max<std::int32_t>(in_slot(most_rates_[i]), 1);
  }
  // Where a slot has no whole number of steps at this rate, the next one has more.
  most_steps_[extruder] = std::min(most_steps_[extruder], in_slot(extruder_rate_) + 1);
}

bool Shaping::configure(const ShapingSettings& settings) {
  int bits = slot_bits_of(clock_);
  if (!filter_.configure(settings, clock_, bits) && !filter_.configure(settings, clock_, ++bits)) {
    return false;
  }
  slot_bits_ = bits;
  slot_time_ = units::Microseconds((std::int64_t{1'000'000} << bits) / clock_.count() + 1);
  limit_steps();
  settings_ = settings;
  active_ = settings.any();
  clear();
  return true;
}

void Shaping::clear() {
  timeline_.clear();
  input_ = {};
  made_ = {};
  filter_.fill(input_);
  elapsed_ = 0;
  resting_slots_ = 0;
  input_rests_ = between_segments_ = at_rest_ = true;
  passes_ = false;
}

Shaping::Output Shaping::next_segment(Planner& planner, units::Microseconds now, bool stocked) {
  // What does not fill a slot is not handed over: the planner is asked earlier by as much.
  now += slot_time_;
  if (at_rest_) {
    const std::optional<Segment> segment = planner.next_segment(now);
    if (!segment) return {};
    if (passes_ || segment->stop_mask != 0) {
      passes_ = !segment->ends_motion;
      return {.segment = segment, .again = true};
    }
    at_rest_ = false;
    missing_ = slot_clocks();
    begin(*segment);
    return {.again = true};
  }
  switch (complete_slot(planner, now, stocked)) {
    case Progress::again:
      return {.again = true};
    case Progress::wait:
      return {};
    case Progress::complete:
      break;
  }
  return {.segment = emit(), .again = true};
}

void Shaping::begin(const Segment& segment) {
  timeline_.begin(segment);
  elapsed_ = 0;
  resting_slots_ = 0;
  between_segments_ = false;
  input_rests_ = segment.ends_motion;
}

Shaping::Progress Shaping::complete_slot(Planner& planner, units::Microseconds now, bool stocked) {
  units::LoopBound<most_phases, 1> segments;  // of a line: it returns between lines
  for (;;) {
    segments.next();
    if (!between_segments_) {
      const std::uint64_t left = timeline_.clocks() - elapsed_;
      if (left >= missing_) {
        elapsed_ += missing_;
        note(timeline_.at(elapsed_));
        resting_slots_ = 0;
        return Progress::complete;
      }
      missing_ -= static_cast<std::uint32_t>(left);
      note(timeline_.end());
      between_segments_ = true;
    }
    if (const std::optional<Segment> segment = planner.next_segment(now)) {
      begin(*segment);
      if (!segment->continues_line) return Progress::again;
      continue;
    }
    if (!input_rests_ || stocked) return Progress::wait;
    ++resting_slots_;
    return Progress::complete;
  }
}

// The planned motion has come to `position`, along one line.
void Shaping::note(const units::PerAxis<FinePosition>& position) {
  if (timeline_.prints()) input_.printed += position[extruder] - input_.position[extruder];
  input_.position = position;
}

Segment Shaping::emit() {
  missing_ = slot_clocks();
  filter_.push(input_);
  Segment segment{.steps = filter_.distance_from(made_)};
  std::uint32_t most = 0;
  bool behind = false;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    std::int32_t& steps = segment.steps[i];
    const std::int32_t wanted = steps;
    steps = std::clamp(wanted, -most_steps_[i], most_steps_[i]);
    behind |= steps != wanted;
    made_[i] += static_cast<FinePosition>(steps) << position_fraction_bits;
    most = std::max(most, units::magnitude(steps));
  }
  // With two ticks for each step of the fastest axis its steps come in the middle of their time, as
  // those of the others do. A slot without steps is one tick.
  const std::uint32_t ticks = std::clamp<std::uint32_t>(most * 2, 1, slot_clocks() / 2);
  segment.line_ticks = segment.ticks = ticks;
  constexpr int rate_fraction_bits = 64;
  segment.rate = std::uint64_t{ticks} << (rate_fraction_bits - slot_bits_);
  at_rest_ = segment.ends_motion = resting_slots_ > filter_.length() && !behind;
  return segment;
}

}  // namespace motion
