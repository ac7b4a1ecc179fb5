// SPDX-License-Identifier: Apache-2.0
// Counters of clocks, like the entities of the same name. `quiet()` is the number of clocks that
// can be skipped: in these nothing but counting happens.
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/simulation/pins.hpp"

namespace counting {

// rtl/processor/timer.vhd: the interrupt changes where the deadline is reached.
struct Timer {
  std::uint64_t now{};
  std::uint64_t deadline{};
  bool reached{};

  sim::Clock quiet() const {
    if (reached) return now >= deadline ? ~now : 0;
    return now < deadline ? deadline - now : 0;
  }
  void carry(sim::Clock clocks) { now += clocks; }

  bool operator==(const Timer&) const = default;
};

// A counter that starts over after its last value and then triggers an event: `tick_phase` and
// `slot_phase` in rtl/thermal.
struct Phase {
  std::uint32_t phase{};
  std::uint32_t last{};

  sim::Clock quiet() const { return phase < last ? last - phase : 0; }
  void carry(sim::Clock clocks) { phase += static_cast<std::uint32_t>(clocks); }

  bool operator==(const Phase&) const = default;
};

// rtl/thermal/temperature_converter.vhd: the clock that a channel waits for, modulo 2^24.
struct Cycles {
  static constexpr std::uint32_t mask = 0xff'ffff;
  std::uint32_t now{};

  sim::Clock quiet_until(std::uint32_t wake) const { return (wake - now) & mask; }
  void carry(sim::Clock clocks) { now = (now + static_cast<std::uint32_t>(clocks)) & mask; }

  bool operator==(const Cycles&) const = default;
};

// rtl/motion/motion_watchdog.vhd, not being fed.
struct MotionWatchdog {
  std::uint32_t limit{};
  bool moving{};
  std::uint32_t left{};
  bool expired{};

  bool counts() const { return limit != 0 && moving && left <= limit && left > 1; }
  sim::Clock quiet() const {
    if (counts()) return expired ? 0 : left - 1;
    return settled() ? sim::never : 0;
  }
  void carry(sim::Clock clocks) {
    if (counts()) left -= static_cast<std::uint32_t>(clocks);
  }

  bool operator==(const MotionWatchdog&) const = default;

 private:
  bool settled() const {
    if (limit == 0) return left == ~std::uint32_t{0} && !expired;
    if (!moving) return left == limit && !expired;
    return left <= 1 && expired;
  }
};

}  // namespace counting
