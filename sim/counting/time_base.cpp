// SPDX-License-Identifier: Apache-2.0
// One clock of the time base, and clocks at a constant rate in one step.
#include "sim/counting/time_base.hpp"

#include <algorithm>

namespace counting {

namespace {

constexpr unsigned acceleration_shift = 20;  // to the rate's unit
constexpr unsigned floor_shift = 32;

}  // namespace

// The change is below 2^46, so that a sum above 3/4 is one below 0.
std::uint64_t TimeBase::changed_rate() const {
  constexpr std::uint64_t highest = std::uint64_t{1} << 63, below_zero = std::uint64_t{3} << 62;
  const std::uint64_t floor = std::uint64_t{rate_floor} << floor_shift;
  const std::uint64_t sum = rate + static_cast<std::uint64_t>(acceleration >> acceleration_shift);
  if (sum >= below_zero) return floor;
  if (sum >= highest) return highest;
  return sum >> floor_shift < rate_floor ? floor : sum;
}

void TimeBase::clock() {
  const std::uint64_t next_rate = changed_rate();
  phase += rate;
  rate = next_rate;
  std::int64_t sum = 0;
  // It stays where the change would take it out of its range.
  if (!__builtin_add_overflow(acceleration, jerk, &sum)) acceleration = sum;
}

// Nothing but the phase changes.
sim::Clock TimeBase::cruise(sim::Clock most) {
  const sim::Clock clocks = rate == 0 ? most : std::min(most, ~phase / rate);
  phase += clocks * rate;
  return clocks;
}

sim::Clock TimeBase::carry(sim::Clock most) {
  if (most == 0) return 0;
  std::int64_t last_acceleration = acceleration;
  sim::Clock clocks = 0;
  if (!counts()) {
    clocks = most;
  } else if (jerk == 0 && changed_rate() == rate) {
    clocks = cruise(most);
  } else {
    for (; clocks < most && !due(); ++clocks) {
      last_acceleration = acceleration;
      clock();
    }
  }
  if (clocks != 0) {
    accelerating = last_acceleration > 0;
    decelerating = last_acceleration < 0;
  }
  return clocks;
}

}  // namespace counting
