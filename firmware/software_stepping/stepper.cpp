// SPDX-License-Identifier: Apache-2.0
// The program's side: prepares blocks, stops, reads positions.
#include "software_stepping/stepper.hpp"

#include <algorithm>
#include <limits>

#include "platform/processor.hpp"
#include "registers/end_stops_registers.hpp"
#include "software_stepping/block_position.hpp"
#include "software_stepping/interrupts.hpp"
#include "units/magnitude.hpp"

namespace software_stepping {
namespace {

constexpr std::uint32_t most_line_ticks = (1u << (31 - pin_bits)) - 1;
constexpr std::uint64_t highest_rate = std::uint64_t{1} << 63;

// Clocks in tick.S, from the instruction that raises the pins: to the one that lowers them, by
// followers, and to the one that changes directions.
constexpr std::array<std::uint32_t, most_quick_followers + 1> clocks_to_fall{16, 27, 27, 32};
constexpr std::uint32_t clocks_to_direction = 24;
// From the end of a pulse to the next that follows with no look at anything.
constexpr std::uint32_t clocks_between_pulses = 13;
// A delay, in addition to its turns.
constexpr std::uint32_t delay_clocks = 5;
constexpr std::uint32_t delay_loop_clocks = 3;

std::uint32_t more_than(std::uint32_t wanted, std::uint32_t clocks) {
  return wanted > clocks ? wanted - clocks : 0;
}

// Turns of the loop that delays by so much at least.
std::uint32_t loops(std::uint32_t clocks) {
  const std::uint32_t in_turns = more_than(clocks, delay_clocks) + delay_loop_clocks - 1;
  return clocks == 0 ? 0 : std::max(std::uint32_t{1}, in_turns / delay_loop_clocks);
}

bool executable(const motion::Segment& segment, std::uint32_t ticks_left) {
  if (segment.ticks == 0 || segment.ticks > ticks_left) return false;
  if (segment.rate > highest_rate || segment.jerk != 0) return false;
  if (segment.stop_on_change || segment.stop_on_release || segment.stop_brakes ||
      segment.waits_for_start) {
    return false;
  }
  if (segment.continues_line) return true;
  if (segment.line_ticks > most_line_ticks) return false;
  const auto too_many = [&](std::int32_t steps) {
    return units::magnitude(steps) > segment.line_ticks;
  };
  return std::ranges::none_of(segment.steps, too_many) &&
         (segment.start.ahead.bits() & segment.start.behind.bits()) == 0;
}

}  // namespace

void Stepper::configure(const Guard& guard, Interval longest_interval) {
  guard_ = guard;
  longest_interval_ = longest_interval;
  // No division later: see interval.cpp.
  hold_delay_ = loops(more_than(guard.direction_hold, clocks_to_direction));
  for (std::size_t i = 0; i < pulse_delays_.size(); ++i) {
    pulse_delays_[i] = loops(more_than(guard.high, clocks_to_fall[i]));
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    blocks_[i].next = &blocks_[(i + 1) % blocks_.size()];
  }
  to_write_ = blocks_.data();
  tick_.block = to_write_;
  tick_.trap_base = ways().careful;
  direction_ = directions_now();
  tick_to_registers();
  permitted_ = true;
}

bool Stepper::append(const motion::Segment& segment) {
  const std::uint32_t left = segment.continues_line ? unassigned_ticks_ : segment.line_ticks;
  if (free() == 0 || stopped_ || !executable(segment, left)) return false;
  Block& block = *to_write_;
  if (segment.continues_line) {
    block.begins_line = 0;
    block.ticks_before = last_->ticks_before + last_->ticks;
    block.line = last_->line;
  } else {
    prepare_line(segment, block);
  }
  prepare(segment, block);
  unassigned_ticks_ = left - segment.ticks;
  const bool is_short = block.short_way != 0 && block.first_interval < shortest_careful_interval;

  const WithoutInterrupts guarded;
  if (stopped_) return false;
  block.number = written_++;
  block.trap_base = is_short ? block.short_way : 0;
  last_ = &block;
  to_write_ = block.next;
  counters_.max_level = std::max(counters_.max_level, level());
  begin_motion();
  return true;
}

void Stepper::prepare_line(const motion::Segment& segment, Block& block) {
  if (unassigned_ticks_ != 0) {
    // The line before ends with what it has got.
    planned_ = positions_after(*last_, last_->ticks_before + last_->ticks);
  }
  block.begins_line = 1;
  block.ticks_before = 0;
  block.line.plain_ticks = segment.line_ticks;
  block.line.ticks = static_cast<std::int32_t>(segment.line_ticks << pin_bits);
  block.line.plain_steps = segment.steps;
  block.line.from = planned_;
  block.line.start = segment.start;
  block.line.steps = {};
  // An axis that does not step.
  block.line.errors.fill(-1);
  block.line.leader = 0;
  std::size_t followers = 0;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    const std::uint32_t steps = units::magnitude(segment.steps[axis]);
    if (steps == 0) continue;
    planned_[axis] += segment.steps[axis];
    const std::uint32_t pin = 1u << axis;
    direction_ = segment.steps[axis] < 0 ? direction_ | pin : direction_ & ~pin;
    if (steps == segment.line_ticks) {
      block.line.leader |= pin;
      continue;
    }
    block.line.steps[followers] = static_cast<std::int32_t>(steps << pin_bits);
    const std::uint32_t error =
        first_error(segment.line_ticks, segment.start, axis) - segment.line_ticks;
    block.line.errors[followers++] = static_cast<std::int32_t>(error << pin_bits | pin);
  }
  block.line.direction = direction_;
  block.line.hold_delay = hold_delay_;
  const bool is_quick = followers <= most_quick_followers;
  block.line.even_way = is_quick ? ways().even[followers] : 0;
  if (!is_quick) return;
  block.line.rest = ways().rest[followers];
  block.line.pulse_delay = pulse_delays_[followers];
}

void Stepper::prepare(const motion::Segment& segment, Block& block) {
  const Ramp ramp = Ramp::of(segment.acceleration);
  block.mantissa = ramp.mantissa;
  block.shift = ramp.shift;
  block.largest_change = largest_short_change >> ramp.shift;
  block.first_interval = first_interval(segment.rate, segment.acceleration, longest_interval_);
  block.set_interval(block.first_interval);
  const bool is_even = ramp.mantissa == 0;
  const std::uintptr_t unwatched = is_even ? block.line.even_way : ways().ramp;
  const bool is_watched = segment.stop_mask != 0;
  block.short_way = block.line.even_way == 0 ? 0 : is_watched ? ways().watched : unwatched;
  block.watch = registers::end_stops::Status{.triggered = segment.stop_mask}.encode();
  block.watched_tick = unwatched + tick_entry_bytes;
  block.tick = block.short_way + tick_entry_bytes;
  const std::uint32_t low = std::max(guard_.low, guard_.direction_setup);
  block.near_clocks = static_cast<std::int32_t>(more_than(low, clocks_to_edge));
  block.quick_behind = std::numeric_limits<std::int32_t>::max();
  if (is_even && !is_watched && low <= clocks_between_pulses) {
    block.near_clocks = 0;
    block.quick_behind = -static_cast<std::int32_t>(block.interval_clocks);
  }
  block.ticks = segment.ticks;
  block.stop_mask = segment.stop_mask;
  block.ends_motion = segment.ends_motion;
}

void Stepper::permit_motion(bool permitted) {
  const WithoutInterrupts guarded;
  permitted_ = permitted;
  begin_motion();
}

void Stepper::flush() {
  const WithoutInterrupts guarded;
  if (moving_) {
    const Block& block = *tick_.block;
    planned_ = positions_after(block, block.ticks_before + block.ticks);
    direction_ = block.line.direction;
  } else {
    planned_ = rest_;
    direction_ = directions_now();
  }
  keep(moving_ ? 1 : 0);
}

// Of those that are not executed yet, only the first.
void Stepper::keep(std::uint32_t blocks) {
  Block* block = tick_.block;
  for (std::uint32_t i = 0; i < blocks; ++i) block = block->next;
  written_ = tick_.block->number + blocks;
  to_write_ = block;
  last_ = tick_.block;
  for (std::size_t i = blocks; i < blocks_.size(); ++i, block = block->next) block->trap_base = 0;
  unassigned_ticks_ = 0;
}

void Stepper::stop() {
  const WithoutInterrupts guarded;
  if (moving_) registers_to_tick();
  stop(std::uint8_t{0});
  set_timer();
  tick_to_registers();
}

bool Stepper::set_position(std::size_t axis, std::int32_t steps) {
  const WithoutInterrupts guarded;
  if (moving_ || level() != 0) return false;
  rest_[axis] = steps;
  planned_[axis] = steps;
  return true;
}

void Stepper::set_alarm(std::uint64_t clocks) {
  const WithoutInterrupts guarded;
  alarm_ = clocks;
  alarm_rang_ = false;
  // Ticks that the interrupt makes by itself come often enough to look at the time after each.
  if (tick_.trap_base == ways().careful) set_timer();
}

bool Stepper::alarm_has_passed() const { return has_come(alarm_); }

Stepper::Positions Stepper::positions_now() const {
  const Block& block = *tick_.block;
  return positions_after(block, block.ticks_before + block.ticks - tick_.left);
}

Stepper::Positions Stepper::positions() const {
  const WithoutInterrupts guarded;
  if (!moving_) return rest_;
  registers_to_tick();
  return positions_now();
}

const Counters& Stepper::counters() const {
  const WithoutInterrupts guarded;
  counters_.segments = written_ - level() + (moving_ ? 1 : 0);
  return counters_;
}

}  // namespace software_stepping
