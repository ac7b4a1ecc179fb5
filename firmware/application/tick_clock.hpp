// SPDX-License-Identifier: Apache-2.0
// Time in milliseconds and microseconds from a count of clocks, without a 64-bit division per look.
#pragma once

#include <cstdint>
#include <limits>

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
    if (const units::Cycles passed = clocks - tick_begin_; clocks >= next_tick()) {
      // A 64-bit division takes the processor a thousand clocks, one of 32 bits 18.
      const std::int64_t ticks =
          passed.count() <= std::numeric_limits<std::uint32_t>::max()
              ? static_cast<std::uint32_t>(passed.count()) / clocks_per_tick_
              : passed.count() / clocks_per_tick_;
      tick_begin_ += units::Cycles(ticks * clocks_per_tick_);
      milliseconds_ += units::Milliseconds(ticks);
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
