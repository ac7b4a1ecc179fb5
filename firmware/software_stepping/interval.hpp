// SPDX-License-Identifier: Apache-2.0
// When the next tick of a ramp comes: the step generator's integration of the tick rate, solved for
// the time of each tick instead of followed clock by clock.
#pragma once

#include <cstdint>

namespace software_stepping {

// Clocks from one tick to the next, in 2^-16. Below 2^32 the interrupt works it out itself.
using Interval = std::uint64_t;
inline constexpr int interval_fraction_bits = 16;

// The ramp of a segment: acceleration in ticks per clock^2 = mantissa * 2^(shift - 64).
struct Ramp {
  std::int32_t mantissa{};
  std::uint32_t shift{};

  static Ramp of(std::int64_t acceleration);  // 2^-84 ticks per clock^2
  bool operator==(const Ramp&) const = default;
};

// From the start of a segment to its first tick: the root of rate T + acceleration T^2 / 2 = 1.
// `rate` in 2^-64 ticks per clock, `acceleration` in 2^-84 ticks per clock^2. At most `longest`,
// which is also the answer where the rate would fall to 0 before the tick.
Interval first_interval(std::uint64_t rate, std::int64_t acceleration, Interval longest);

// The interval after `interval`. With e = acceleration * interval^2, the relative change of the
// rate from one interval to the next, it is interval * y where e/2 y^2 + (1 + e/2) y = 1.
Interval next_interval(Interval interval, Ramp ramp, Interval longest);

// Positive root y < 3 of a y^2 + b y = 1, all in 2^-28; 0 where there is none. |a| + b < 8.
std::int32_t positive_root(std::int32_t a, std::int32_t b);

// The changes up to which, and the intervals below which next_interval() is done without division.
inline constexpr std::uint32_t largest_short_change = 1u << 28;  // parts of 1 are 2^-32
inline constexpr std::uint32_t too_long_interval = 1u << 29;

// The same as next_interval() for intervals below 2^29 (8192 clocks) and |e| < 2^-4, where
// y = 1 - e + 3/2 e^2 - 11/4 e^3 is off by less than 5.5 e^4: multiplications only. False where the
// interval does not lie in that range, or leaves it; it is unchanged then.
inline bool advance_short_interval(std::uint32_t& interval, std::int32_t mantissa,
                                   std::uint32_t shift) {
  const auto upper = [](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>((std::int64_t{a} * b) >> 32);
  };
  const auto old = static_cast<std::int32_t>(interval);
  const auto unshifted = static_cast<std::uint32_t>(upper(mantissa, upper(old, old)));
  const std::uint32_t limit = largest_short_change >> shift;
  if (unshifted + limit >= 2 * limit) return false;
  const auto e = static_cast<std::int32_t>(unshifted << shift);
  const std::int32_t square = upper(e, e);
  const std::int32_t cube = upper(square, e);
  const std::int32_t less = e - square - (square >> 1) + 3 * cube - (cube >> 2);
  const auto next = static_cast<std::uint32_t>(old - upper(less, old));
  if (next >= too_long_interval) return false;
  interval = next;
  return true;
}

}  // namespace software_stepping
