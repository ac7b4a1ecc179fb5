// SPDX-License-Identifier: Apache-2.0
// What the interrupt works on: blocks that the program has prepared, and the tick that is due. The
// order of both is known to tick.S.
#pragma once

#include <array>
#include <cstdint>

#include "motion/segment.hpp"
#include "software_stepping/interval.hpp"
#include "units/axes.hpp"

namespace software_stepping {

inline constexpr std::size_t most_followers = units::axis_count;
// With more no tick is made the short way: only where no axis steps at each tick.
inline constexpr std::size_t most_quick_followers = 3;

// Error terms and steps stand 8 bits higher, so that an error term carries its axis' pin in the
// bits below: a tick ors it to the pins as it is.
inline constexpr int pin_bits = 8;

// From the fraction of an interval to 2^-32 clocks.
inline constexpr int interval_fraction_shift = 32 - interval_fraction_bits;

// What is the same in all segments of a line.
struct Line {
  std::uintptr_t rest{};  // how a tick goes on after its edge
  std::uint32_t leader{};  // pins that step at each tick
  // Of the axes that step at some ticks; their error terms count from -ticks up to -1.
  std::int32_t ticks{};
  std::array<std::int32_t, most_followers> steps{};
  std::array<std::int32_t, most_followers> errors{};  // with which it begins
  std::uint32_t pulse_delay{};  // turns of a loop of 3 clocks
  std::uint32_t hold_delay{};
  std::uint32_t direction{};

  // From here on for the program.
  std::uintptr_t even_way{};  // of ticks at a constant rate; 0: none
  std::uint32_t plain_ticks{};
  units::PerAxis<std::int32_t> plain_steps{};
  units::PerAxis<std::int32_t> from{};  // positions
  motion::LineStart start{};
};

// A segment, with all that can be known of it in advance.
struct Block {
  Block* next{};
  // Where the interrupt of its ticks begins, as mtvec has it; 0: nothing here that it could begin
  // by itself.
  std::uintptr_t trap_base{};
  std::uintptr_t tick{};  // its first instruction
  std::uint32_t interval_fraction{};  // 2^-32 clocks
  std::uint32_t interval_clocks{};
  std::int32_t near_clocks{};  // a tick that is nearer is waited for in the interrupt
  std::int32_t quick_behind{};  // so far behind the next one follows with no look at anything
  std::uint32_t ticks{};
  std::uint32_t begins_line{};
  std::uint32_t interval{};  // of a ramp, below 2^29 (interval.hpp)
  std::int32_t mantissa{};
  std::uint32_t shift{};
  std::uint32_t largest_change{};
  std::uint32_t watch{};  // the bits of the end stops' status that end all motion
  std::uintptr_t watched_tick{};  // what follows where none is triggered
  Line line{};

  // From here on for the program.
  std::uintptr_t short_way{};  // `trap_base` wherever its intervals are short
  Interval first_interval{};
  std::uint32_t number{};
  std::uint32_t ticks_before{};  // of the line
  std::uint8_t stop_mask{};
  bool ends_motion{};

  void set_interval(Interval value) {
    interval = static_cast<std::uint32_t>(value);
    interval_clocks = interval >> interval_fraction_bits;
    interval_fraction = interval << interval_fraction_shift;
  }
};

// What is due next. The pins are worked out one tick ahead, so that the edge comes first. While the
// interrupt makes ticks by itself, all but the block and the deadline's upper half are in registers
// that nothing else uses.
struct Tick {
  Block* block{};
  std::uint32_t pins{};  // bits above the pins' are not 0
  std::array<std::int32_t, most_followers> errors{};
  std::uint32_t fraction{};  // of the deadline, 2^-32 clocks
  std::uint32_t deadline_low{}, deadline_high{};
  std::uint32_t left{};  // ticks of the block that are not made yet
  std::uintptr_t trap_base{};
};

// Cases that the interrupt leaves to attend().
enum class Attention : std::uint32_t {
  careful,  // at rest, end stops, long intervals: nothing is done yet
  block_ends,  // its last tick is made, and the next block is not one that it can begin
  interval,  // the next one of a ramp is too long, or changes too much
  late,  // the next tick is late by more than an interval
};

// Addresses in tick.S.
// From a trap base, with its lowest bit, to the first instruction of the timer interrupt.
inline constexpr std::uintptr_t tick_entry_bytes = 27;

struct Ways {
  std::uintptr_t careful{};  // all is done by attend()
  std::uintptr_t watched{};  // with end stops
  std::uintptr_t ramp{};
  std::array<std::uintptr_t, most_quick_followers + 1> even{};  // by followers
  std::array<std::uintptr_t, most_quick_followers + 1> rest{};
};

// Defined once per program, as the bus.
const Ways& ways();

}  // namespace software_stepping
