// SPDX-License-Identifier: Apache-2.0
// Time in milliseconds and microseconds from a count of clocks, without a 64-bit division per look.
#pragma once

#include <cstdint>

#include "units/loop_bound.hpp"
#include "units/quantity.hpp"

namespace application {

struct Now {
  units::Milliseconds milliseconds{};
  units::Microseconds microseconds{};
};

class TickClock {
 public:
  // A tick is a millisecond, to within one clock: at 4 MHz and more off by less than 0.03 %.
  explicit constexpr TickClock(units::Hertz clock) : clocks_per_tick_(clock.count() / 1000) {}

  Now update(units::Cycles clocks) {
    // Of more a division finds the number.
    constexpr std::uint32_t most_ticks = 32;
    units::LoopBound<most_ticks + 1> begun;
    for (std::uint32_t i = 0; clocks >= next_tick(); ++i) {
      begun.next();
      if (i == most_ticks) {
        const std::int64_t ticks = (clocks - tick_begin_).count() / clocks_per_tick_;
        tick_begin_ += units::Cycles(ticks * clocks_per_tick_);
        milliseconds_ += units::Milliseconds(ticks);
        break;
      }
      tick_begin_ += units::Cycles(clocks_per_tick_);
      milliseconds_ += units::Milliseconds(1);
    }
    const auto into_tick = static_cast<std::uint32_t>((clocks - tick_begin_).count());
    const std::uint32_t part = into_tick * 1000 / clocks_per_tick_;  // clocks_per_tick < 2^22
    return {milliseconds_, units::Microseconds(milliseconds_.count() * 1000 + part)};
  }

  units::Cycles next_tick() const { return tick_begin_ + units::Cycles(clocks_per_tick_); }
  // When so many ticks from now have begun.
  units::Cycles in_ticks(std::uint32_t ticks) const {
    return tick_begin_ + units::Cycles(std::int64_t{clocks_per_tick_} * ticks);
  }

 private:
  std::uint32_t clocks_per_tick_;
  units::Cycles tick_begin_{};
  units::Milliseconds milliseconds_{};
};

}  // namespace application
