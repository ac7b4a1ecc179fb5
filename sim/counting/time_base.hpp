// SPDX-License-Identifier: Apache-2.0
// Rate and phase of the step generator's time base between two ticks, as rtl/motion/time_base.vhd
// integrates them in each clock.
#pragma once

#include <cstdint>

#include "sim/simulation/pins.hpp"

namespace counting {

// Phase and rate in 2^-64 ticks (per clock), acceleration and jerk in 2^-84 ticks per clock^2 and
// clock^3; the floor of the rate in 2^-32 ticks per clock.
struct TimeBase {
  bool active{};  // a segment is executed
  bool advance{};  // time passes for the base
  std::uint64_t phase{};
  std::uint64_t rate{};
  std::int64_t acceleration{};
  std::int64_t jerk{};
  std::uint32_t rate_floor{};
  bool accelerating{};
  bool decelerating{};

  // The next clock is one with a tick.
  bool due() const { return counts() && phase + rate < phase; }

  // Up to `most` clocks; ends where a tick is due. Returns the clocks carried over.
  sim::Clock carry(sim::Clock most);

  bool operator==(const TimeBase&) const = default;

 private:
  bool counts() const { return active && advance; }
  void clock();
  std::uint64_t changed_rate() const;
  sim::Clock cruise(sim::Clock most);
};

}  // namespace counting
