// SPDX-License-Identifier: Apache-2.0
// One tick in the timer interrupt: what nearly all of them need, in as few clocks as possible.
#pragma once

#include <cstdint>

#include "drivers/registers/step_pins_registers.hpp"
#include "drivers/registers/timer_registers.hpp"
#include "platform/bus.hpp"
#include "platform/processor.hpp"
#include "software_stepping/interval.hpp"

namespace software_stepping {

// From the timer's deadline to a rising edge take at least so many clocks: what the guard demands
// is over so much earlier.
inline constexpr std::uint32_t shortest_latency_clocks = 16;

// An axis that steps at some of a line's ticks: Bresenham's error term, which counts from
// -line_ticks up to -1, what each tick adds to it, and the pin.
struct Follower {
  std::int32_t error{};
  std::int32_t steps{};  // 0: the list ends here
  std::uint32_t pin{};
};

enum class Mode : std::int32_t {
  careful = -1,  // at rest, or ticks that the short way does not suit: all is done by attend()
  even = 0,  // all intervals alike
  ramp = 1,
};

enum class Attention : std::uint32_t {
  careful,
  segment_ends,  // its last tick has been made
  interval,  // the next one does not fit the short way
  late,  // the next tick's time has come already, or the guard forbids it
};

// What is due next. The pins are worked out one tick ahead, so that the edge comes first.
struct Tick {
  Mode mode{Mode::careful};
  std::uint32_t pins{};
  std::uint32_t left{};  // ticks of the segment that are not made yet
  std::uint32_t leader{};
  std::uint32_t interval{};  // below 2^29; see interval.hpp
  std::uint32_t interval_high{};  // only in careful mode
  Ramp ramp{};
  // Time of the next tick: clocks, and 2^-16 of them.
  std::uint32_t fraction{};
  std::uint32_t deadline_low{}, deadline_high{};
  std::uint32_t high_clocks{1};
  std::int32_t margin_clocks{};  // a deadline that is nearer than this needs attention
  std::int32_t line_ticks{};
  std::uint32_t rose{};  // clock of the last rising edge
  Follower* followers{};  // of the line, where it lies in the queue
};

// Which pins the next tick raises.
[[gnu::always_inline]] inline std::uint32_t next_pins(Tick& tick) {
  std::uint32_t pins = tick.leader;
  for (Follower* follower = tick.followers; follower->steps != 0; ++follower) {
    std::int32_t error = follower->error + follower->steps;
    if (error >= 0) {
      error -= tick.line_ticks;
      pins |= follower->pin;
    }
    follower->error = error;
  }
  return pins;
}

[[gnu::always_inline]] inline void raise(Tick& tick) {
  platform::write(registers::step_pins::Step{tick.pins});
  tick.rose = platform::clocks();
}

// Ends the pulse when it has its width.
[[gnu::always_inline]] inline void fall(const Tick& tick) {
  while (platform::clocks() - tick.rose < tick.high_clocks) {
  }
  platform::write(registers::step_pins::Step{0});
}

[[gnu::always_inline]] inline void set_timer(const Tick& tick) {
  platform::write(registers::timer::CompareLow{tick.deadline_low});
  platform::write(registers::timer::CompareHigh{tick.deadline_high});
}

// The interrupt. `attend` is called with what this way does not cover.
template <class Attend>
[[gnu::always_inline]] inline void on_timer(Tick& tick, Attend attend) {
  const Mode mode = tick.mode;
  if (mode == Mode::careful) {
    attend(Attention::careful);
    return;
  }
  raise(tick);
  if (--tick.left == 0) {
    fall(tick);
    attend(Attention::segment_ends);
    return;
  }
  if (mode == Mode::ramp &&
      !advance_short_interval(tick.interval, tick.ramp.mantissa, tick.ramp.shift)) {
    fall(tick);
    attend(Attention::interval);
    return;
  }
  tick.pins = next_pins(tick);
  const std::uint32_t sum = tick.fraction + tick.interval;
  tick.fraction = sum & 0xFFFF;
  const std::uint32_t clocks = sum >> interval_fraction_bits;
  tick.deadline_low += clocks;
  tick.deadline_high += tick.deadline_low < clocks ? 1 : 0;
  fall(tick);
  if (static_cast<std::int32_t>(tick.deadline_low - platform::clocks()) < tick.margin_clocks) {
    attend(Attention::late);
    return;
  }
  set_timer(tick);
}

}  // namespace software_stepping
