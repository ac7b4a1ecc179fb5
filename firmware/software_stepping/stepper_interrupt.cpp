// SPDX-License-Identifier: Apache-2.0
// The cases that the assembly leaves to C++: the start, long intervals, end stops, stops, delays.
#include <algorithm>

#include "platform/bus.hpp"
#include "platform/processor.hpp"
#include "registers/end_stops_registers.hpp"
#include "registers/step_pins_registers.hpp"
#include "registers/timer_registers.hpp"
#include "software_stepping/block_position.hpp"
#include "software_stepping/interrupts.hpp"
#include "software_stepping/stepper.hpp"

namespace software_stepping {
namespace {

// From rest, until the timer is set and the interrupt is enabled.
constexpr std::uint32_t clocks_to_begin = 100;

std::uint64_t deadline_of(const Tick& tick) {
  return std::uint64_t{tick.deadline_high} << 32 | tick.deadline_low;
}

void set_deadline(Tick& tick, std::uint64_t clocks) {
  tick.deadline_low = static_cast<std::uint32_t>(clocks);
  tick.deadline_high = static_cast<std::uint32_t>(clocks >> 32);
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

}  // namespace

std::uint32_t Stepper::directions_now() {
  return platform::read<registers::step_pins::Direction>().pins;
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
  if (is_short) block.set_interval(interval);
  tick_.trap_base = is_short ? block.short_way : ways().careful;
  const auto fraction = static_cast<std::uint32_t>(interval) << interval_fraction_shift;
  tick_.fraction += fraction;
  const std::uint32_t carry = tick_.fraction < fraction ? 1 : 0;
  set_deadline(tick_, deadline_of(tick_) + (interval >> interval_fraction_bits) + carry);
}

// A tick that is late comes at once, and time goes on. One that is late by more than an interval,
// or that the guard forbids for so long, delays all that follow: the path stays, and the clocks
// of the delay are counted.
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

// With interrupts masked.
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
