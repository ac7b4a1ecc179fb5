// SPDX-License-Identifier: Apache-2.0
// Prepares blocks, and hands over what the interrupt does not do by itself: the start, long
// intervals, end stops, stops, delays.
#include "software_stepping/stepper.hpp"

#include <algorithm>
#include <limits>

#include "platform/bus.hpp"
#include "platform/division.hpp"
#include "platform/processor.hpp"
#include "registers/end_stops_registers.hpp"
#include "registers/step_pins_registers.hpp"
#include "registers/timer_registers.hpp"
#include "software_stepping/interrupts.hpp"

namespace software_stepping {
namespace {

constexpr std::uint32_t most_line_ticks = (1u << (31 - pin_bits)) - 1;
constexpr std::uint64_t highest_rate = std::uint64_t{1} << 63;
constexpr Interval shortest_careful_interval = too_long_interval;
constexpr int fraction_shift = 32 - interval_fraction_bits;

// Clocks in tick.S, from the instruction that raises the pins: to the one that lowers them, by
// followers, and to the one that changes directions.
constexpr std::array<std::uint32_t, most_quick_followers + 1> clocks_to_fall{16, 27, 27, 32};
constexpr std::uint32_t clocks_to_direction = 24;
// From the end of a pulse to the next that follows with no look at anything.
constexpr std::uint32_t clocks_between_pulses = 13;
// From the end of a pulse to the timer's deadline, less than what passes to the next edge.
constexpr std::uint32_t clocks_to_edge = 4;
// A delay, in addition to its turns.
constexpr std::uint32_t delay_clocks = 5;
constexpr std::uint32_t delay_loop_clocks = 3;
// From rest, until the timer is set and the interrupt let in.
constexpr std::uint32_t clocks_to_begin = 100;

std::uint32_t magnitude(std::int32_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  return value < 0 ? 0 - word : word;
}

// Bresenham's error term with which an axis begins a line (see motion/segment.hpp).
std::uint32_t first_error(std::uint32_t ticks, motion::LineStart start, std::size_t axis) {
  const std::uint32_t half = ticks / 2;
  const std::uint32_t quarter = ticks / 4;
  if (start.behind.contains(static_cast<units::Axis>(axis))) return quarter;
  return start.ahead.contains(static_cast<units::Axis>(axis)) ? half + quarter : half;
}

// Steps of an axis after so many ticks of the line.
std::int32_t steps_after(const Line& line, std::uint32_t ticks, std::size_t axis) {
  const std::uint32_t steps = magnitude(line.plain_steps[axis]);
  if (steps == 0) return 0;
  const std::uint64_t sum =
      std::uint64_t{ticks} * steps + first_error(line.plain_ticks, line.start, axis);
  const auto done = static_cast<std::int32_t>(platform::divide(sum, line.plain_ticks));
  return line.plain_steps[axis] < 0 ? -done : done;
}

Stepper::Positions positions_after(const Block& block, std::uint32_t ticks) {
  Stepper::Positions result = block.line.from;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    result[axis] += ticks == block.line.plain_ticks ? block.line.plain_steps[axis]
                                                    : steps_after(block.line, ticks, axis);
  }
  return result;
}

std::uint64_t deadline_of(const Tick& tick) {
  return std::uint64_t{tick.deadline_high} << 32 | tick.deadline_low;
}

void set_deadline(Tick& tick, std::uint64_t clocks) {
  tick.deadline_low = static_cast<std::uint32_t>(clocks);
  tick.deadline_high = static_cast<std::uint32_t>(clocks >> 32);
}

void set_interval(Block& block, Interval interval) {
  block.interval = static_cast<std::uint32_t>(interval);
  block.interval_clocks = block.interval >> interval_fraction_bits;
  block.interval_fraction = block.interval << fraction_shift;
}

// Which pins the next tick raises.
std::uint32_t next_pins(Tick& tick) {
  const Block& block = *tick.block;
  std::uint32_t pins = block.line.leader;
  for (std::size_t i = 0; i < most_followers && block.line.steps[i] != 0; ++i) {
    std::int32_t& error = tick.errors[i];
    error += block.line.steps[i];
    if (error < 0) continue;
    pins |= static_cast<std::uint32_t>(error);
    error -= block.line.ticks;
  }
  return pins;
}

std::uint32_t more_than(std::uint32_t wanted, std::uint32_t clocks) {
  return wanted > clocks ? wanted - clocks : 0;
}

// Turns of the loop that delays by so much at least.
std::uint32_t loops(std::uint32_t clocks) {
  const std::uint32_t in_turns = more_than(clocks, delay_clocks) + delay_loop_clocks - 1;
  return clocks == 0 ? 0 : std::max(std::uint32_t{1}, in_turns / delay_loop_clocks);
}

std::uint32_t directions_now() { return platform::read<registers::step_pins::Direction>().pins; }

bool executable(const motion::Segment& segment, std::uint32_t ticks_left) {
  if (segment.ticks == 0 || segment.ticks > ticks_left) return false;
  if (segment.rate > highest_rate || segment.jerk != 0) return false;
  if (segment.stop_on_change || segment.stop_on_release || segment.stop_brakes ||
      segment.waits_for_start) {
    return false;
  }
  if (segment.continues_line) return true;
  if (segment.line_ticks > most_line_ticks) return false;
  const auto too_many = [&](std::int32_t steps) { return magnitude(steps) > segment.line_ticks; };
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
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    blocks_[i].next = &blocks_[(i + 1) % blocks_.size()];
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
    const std::uint32_t steps = magnitude(segment.steps[axis]);
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
  set_interval(block, block.first_interval);
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

void Stepper::attend(Attention reason) {
  if (reason != Attention::careful) {
    interval_ = tick_.block->interval;
    pulse_is_over();
  }
  switch (reason) {
    case Attention::careful:
      if (make_tick_with_care()) break;
      // An alarm just before a tick does not make the tick late.
      set_timer();
      return;
    case Attention::block_ends:
      end_segment();
      break;
    case Attention::interval: {
      const Block& block = *tick_.block;
      tick_.pins = next_pins(tick_);
      go_on_after(next_interval(interval_, {block.mantissa, block.shift}, longest_interval_));
      break;
    }
    case Attention::late:
      break;
  }
  schedule();
}

void Stepper::raise() {
  platform::write(registers::step_pins::Step{tick_.pins & ((1u << pin_bits) - 1)});
  rose_ = platform::clocks();
}

// Ends the pulse when it has its width.
void Stepper::fall() {
  while (platform::clocks() - rose_ < guard_.high) {
  }
  platform::write(registers::step_pins::Step{0});
}

bool Stepper::make_tick_with_care() {
  const std::uint64_t now = long_clocks();
  // It ends the sleep by itself; the interrupt shall not come again for it.
  if (now >= alarm_) alarm_rang_ = true;
  if (!moving_ || now < std::max(deadline_of(tick_), earliest_)) return false;
  const Block& block = *tick_.block;
  if (tick_.trap_base != ways().careful) interval_ = block.interval;
  if (block.stop_mask != 0) {
    const auto triggered = platform::read<registers::end_stops::Status>().triggered;
    if (const auto hits = static_cast<std::uint8_t>(triggered & block.stop_mask)) {
      stop(hits);
      return true;
    }
  }
  raise();
  fall();
  pulse_is_over();
  if (--tick_.left == 0) {
    end_segment();
    return true;
  }
  tick_.pins = next_pins(tick_);
  go_on_after(next_interval(interval_, {block.mantissa, block.shift}, longest_interval_));
  return true;
}

// Its last pulse is over.
void Stepper::end_segment() {
  Block& block = *tick_.block;
  block.trap_base = 0;
  const bool is_last = level() == 1;
  tick_.block = block.next;
  if (!is_last) {
    begin_segment();
    return;
  }
  tick_.block->number = written_;
  if (!block.ends_motion) ++counters_.underruns;
  come_to_rest(positions_after(block, block.ticks_before + block.ticks));
}

void Stepper::begin_segment() {
  Block& block = *tick_.block;
  if (block.begins_line != 0) begin_line();
  tick_.left = block.ticks;
  tick_.pins = next_pins(tick_);
  go_on_after(block.first_interval);
}

void Stepper::begin_line() {
  const Block& block = *tick_.block;
  tick_.errors = block.line.errors;
  if (block.line.direction == directions_now()) return;
  while (platform::clocks() - rose_ < guard_.direction_hold) {
  }
  platform::write(registers::step_pins::Direction{block.line.direction});
  earliest_ = std::max(earliest_, long_clocks() + guard_.direction_setup);
}

void Stepper::go_on_after(Interval interval) {
  interval_ = interval;
  Block& block = *tick_.block;
  const bool is_short = interval < shortest_careful_interval && block.short_way != 0;
  if (is_short) set_interval(block, interval);
  tick_.trap_base = is_short ? block.short_way : ways().careful;
  const auto fraction = static_cast<std::uint32_t>(interval) << fraction_shift;
  tick_.fraction += fraction;
  const std::uint32_t carry = tick_.fraction < fraction ? 1 : 0;
  set_deadline(tick_, deadline_of(tick_) + (interval >> interval_fraction_bits) + carry);
}

// A tick that is late comes at once, and time goes on. One that is late by more than an interval,
// or that the guard forbids for so long, delays all that follow: the path stays, the clocks are
// counted.
void Stepper::schedule() {
  if (moving_) {
    const std::uint64_t deadline = deadline_of(tick_);
    const std::uint64_t earliest = std::max(long_clocks(), earliest_);
    if (deadline + (interval_ >> interval_fraction_bits) < earliest) {
      ++counters_.late_ticks;
      counters_.delay_clocks += static_cast<std::uint32_t>(earliest - deadline);
      set_deadline(tick_, earliest);
    }
  }
  set_timer();
}

void Stepper::set_timer() {
  std::uint64_t next = alarm_rang_ ? never : alarm_;
  if (moving_) {
    // Ticks that the interrupt makes by itself end sleep often enough for an alarm.
    const std::uint64_t deadline = std::max(deadline_of(tick_), earliest_);
    next = tick_.trap_base == ways().careful ? std::min(deadline, next) : deadline;
  }
  platform::write(registers::timer::Compare{next});
}

void Stepper::pulse_is_over() {
  // The edge was earlier, if the interrupt has made it.
  rose_ = platform::clocks();
  earliest_ = long_clocks() + guard_.low;
  earliest_ -= std::min(guard_.low, clocks_to_edge);
}

// With interrupts kept out.
void Stepper::begin_motion() {
  if (moving_ || !permitted_ || level() == 0) return;
  moving_ = true;
  begin_segment();
  // From rest time begins when all is ready.
  tick_.fraction = 0;
  set_deadline(tick_, long_clocks() + (interval_ >> interval_fraction_bits) + clocks_to_begin);
  set_timer();
  tick_to_registers();
}

// A line that was left in its middle may still be continued.
void Stepper::come_to_rest(const Positions& positions) {
  rest_ = positions;
  moving_ = false;
  tick_.trap_base = ways().careful;
}

// No step from now on: a pulse that is out has been ended by its maker.
void Stepper::stop(std::uint8_t end_stops) {
  if (stopped_) return;
  stopped_ = true;
  stop_cause_ = end_stops;
  stop_clock_ = long_clocks();
  if (moving_) come_to_rest(positions_now());
  planned_ = rest_;
  direction_ = directions_now();
  keep(0);
}

}  // namespace software_stepping
