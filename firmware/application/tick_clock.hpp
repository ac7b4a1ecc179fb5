// SPDX-License-Identifier: Apache-2.0
// Time in milliseconds and microseconds from a count of clocks, without a division per look.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace application {

struct Now {
  units::Milliseconds milliseconds{};
  units::Microseconds microseconds{};
};

class TickClock {
 public:
  // A tick is a millisecond, to within one clock: at 4 MHz and more off by less than 0.03 %.
  explicit constexpr TickClock(units::Hertz clock)
      : clocks_per_tick_(clock.count() / 1000),
        ticks_per_clock_(static_cast<std::uint32_t>(word / clocks_per_tick_)),
        // Rounded up: the first clock of a microsecond is in it, and the last of a tick below 1000.
        microseconds_per_clock_(
            static_cast<std::uint32_t>((word * 1000 + clocks_per_tick_ - 1) / clocks_per_tick_)),
        clocks_per_microsecond_(
            static_cast<std::uint32_t>((std::uint64_t{clocks_per_tick_} << fraction_bits) / 1000)) {
  }

  Now update(units::Cycles clocks) {
    const auto passed = static_cast<std::uint64_t>((clocks - tick_begin_).count());
    if (passed >= word) {
      count(static_cast<std::int64_t>(passed) / clocks_per_tick_);
    } else if (const std::uint32_t ticks = ticks_in(static_cast<std::uint32_t>(passed)); ticks) {
      count(ticks);
    }
    const auto into_tick = static_cast<std::uint32_t>((clocks - tick_begin_).count());
    const std::uint64_t part = std::uint64_t{into_tick} * microseconds_per_clock_ / word;
    return {milliseconds_, microseconds_ + units::Microseconds(static_cast<std::int64_t>(part))};
  }

  units::Cycles next_tick() const { return tick_begin_ + units::Cycles(clocks_per_tick_); }
  // When so many ticks from now have begun.
  units::Cycles in_ticks(std::uint32_t ticks) const {
    return tick_begin_ + units::Cycles(std::int64_t{clocks_per_tick_} * ticks);
  }
  // Whole ticks in so many clocks.
  std::uint32_t ticks_in(std::uint32_t clocks) const {
    // Of the number rounded down, or one less.
    const auto ticks = static_cast<std::uint32_t>(std::uint64_t{clocks} * ticks_per_clock_ / word);
    return ticks + (clocks - ticks * clocks_per_tick_ >= clocks_per_tick_ ? 1 : 0);
  }
  // Clocks in so many microseconds, below an hour, rounded down; modulo 2^32.
  std::uint32_t clocks_in(std::uint32_t microseconds) const {
    return static_cast<std::uint32_t>(std::uint64_t{microseconds} * clocks_per_microsecond_ >>
                                      fraction_bits);
  }

 private:
  static constexpr std::uint64_t word = std::uint64_t{1} << 32;
  static constexpr unsigned fraction_bits = 20;

  void count(std::int64_t ticks) {
    tick_begin_ += units::Cycles(ticks * clocks_per_tick_);
    milliseconds_ += units::Milliseconds(ticks);
    microseconds_ += units::Microseconds(ticks * 1000);
  }

  std::uint32_t clocks_per_tick_;  // 4000 to 200'000
  std::uint32_t ticks_per_clock_, microseconds_per_clock_;  // of 2^32
  std::uint32_t clocks_per_microsecond_;  // with `fraction_bits` fractional bits
  units::Cycles tick_begin_{};
  units::Microseconds microseconds_{};  // at the tick's beginning
  units::Milliseconds milliseconds_{};
};

}  // namespace application
