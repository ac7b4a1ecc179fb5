// SPDX-License-Identifier: Apache-2.0
// Intervals where a series does not do: the first of a ramp, and those near rest.
#include "software_stepping/interval.hpp"

#include <algorithm>
#include <bit>

#include "motion/scaled.hpp"
#include "platform/division.hpp"
#include "units/magnitude.hpp"

namespace software_stepping {
namespace {

using motion::Scaled;

constexpr int rate_fraction_bits = 64;
constexpr int acceleration_fraction_bits = 84;
constexpr int ramp_fraction_bits = 64;
constexpr int root_fraction_bits = 28;
constexpr std::int32_t one = 1 << root_fraction_bits;
constexpr std::int32_t largest_root = 3 * one;

std::int32_t product(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b) >> root_fraction_bits);
}

// interval * y, to the nearest 2^-16 clock.
Interval scaled_by_root(Interval interval, std::int32_t root) {
  const auto factor = static_cast<std::uint64_t>(root);
  constexpr std::uint64_t half = 1u << (root_fraction_bits - 1);
  const std::uint64_t low = (interval & 0xFFFF'FFFF) * factor + half;
  return ((interval >> 32) * factor << (32 - root_fraction_bits)) + (low >> root_fraction_bits);
}

Interval nearest_interval(Scaled clocks) {
  const std::uint64_t halves = clocks.floor(interval_fraction_bits + 1);
  return halves / 2 + halves % 2;
}

}  // namespace

Ramp Ramp::of(std::int64_t acceleration) {
  std::int64_t mantissa = acceleration >> (acceleration_fraction_bits - ramp_fraction_bits);
  std::uint32_t shift = 0;
  for (; mantissa != static_cast<std::int32_t>(mantissa); mantissa >>= 1) ++shift;
  return {static_cast<std::int32_t>(mantissa), shift};
}

// Newton's method. A correction is divided with what precision its residual leaves room for.
std::int32_t positive_root(std::int32_t a, std::int32_t b) {
  constexpr int slope_fraction_bits = 15;
  constexpr int slope_shift = root_fraction_bits - slope_fraction_bits;
  std::int32_t root = one;
  for (int i = 0; i < 12; ++i) {
    const std::int32_t a_root = product(a, root);
    const std::int32_t residual = one - product(b + a_root, root);
    const std::int32_t slope = (b >> slope_shift) + (a_root >> (slope_shift - 1));
    if (slope <= 0) return 0;
    const std::int32_t size = residual < 0 ? -residual : residual;
    const int spare_bits = size < 1 << 15 ? 15 : size < 1 << 22 ? 8 : 0;
    const std::int32_t correction =
        residual * (1 << spare_bits) / slope * (1 << (slope_fraction_bits - spare_bits));
    root += correction;
    if (root <= 0 || root >= largest_root) return 0;
    if (spare_bits == slope_fraction_bits) return root;
  }
  return 0;
}

// 2^63 / divisor without a division: where ticks leave the program fewer clocks than one takes, it
// would start over after each, forever. 2^33 <= divisor < 2^47.
std::uint64_t quotient_of_2_63(std::uint64_t divisor) {
  const auto upper = static_cast<std::uint32_t>(divisor >> 15);
  const auto shift = static_cast<unsigned>(std::countl_zero(upper));
  const auto normal = static_cast<std::uint32_t>(divisor << shift >> 15);
  const auto high = [](std::uint32_t a, std::uint32_t b) {
    return static_cast<std::uint32_t>((std::uint64_t{a} * b) >> 32);
  };
  // 1 / d for 1/2 <= d < 1 by Newton's method, from 48/17 - 32/17 d; with 30 bits after the point.
  constexpr auto constant = static_cast<std::uint32_t>((48ull << 30) / 17);
  constexpr auto slope = static_cast<std::uint32_t>((32ull << 30) / 17);
  std::uint32_t inverse = constant - high(slope, normal);
  for (int i = 0; i < 3; ++i) inverse = high(inverse, (1u << 31) - high(inverse, normal)) << 2;
  std::uint64_t quotient = std::uint64_t{inverse} >> (14 - shift);
  auto rest = static_cast<std::int64_t>((std::uint64_t{1} << 63) - quotient * divisor);
  for (; rest < 0; rest += static_cast<std::int64_t>(divisor)) --quotient;
  for (; rest >= static_cast<std::int64_t>(divisor); rest -= static_cast<std::int64_t>(divisor)) {
    ++quotient;
  }
  return quotient;
}

// At a constant rate, from 2^-13 ticks per clock on.
Interval interval_at(std::uint64_t rate, Interval longest) {
  const std::uint64_t halves = quotient_of_2_63(rate >> 18);
  return std::min(longest, halves / 2 + halves % 2);
}

Interval first_interval(std::uint64_t rate, std::int64_t acceleration, Interval longest) {
  constexpr std::uint64_t least_short_rate = std::uint64_t{1} << 51;
  if (acceleration == 0 && rate >= least_short_rate) return interval_at(rate, longest);
  const Scaled size = Scaled::of(units::magnitude(acceleration), -acceleration_fraction_bits);
  // What a constant rate would take, and the change of the rate in that time, as a part of it.
  const Scaled constant =
      Scaled::of(1) / Scaled::of(std::max<std::uint64_t>(rate, 1), -rate_fraction_bits);
  constexpr std::uint64_t from_rest = std::uint64_t{12} << root_fraction_bits;
  const std::uint64_t change = (size * constant * constant).floor(root_fraction_bits);
  if (acceleration > 0 && change >= from_rest) {
    return std::min(longest, nearest_interval((Scaled::of(2) / size).square_root()));
  }
  const Interval interval = nearest_interval(constant);
  if (interval >= longest || (acceleration < 0 && change >= one)) return longest;
  const auto half = static_cast<std::int32_t>(change / 2);
  const std::int32_t root = positive_root(acceleration < 0 ? -half : half, one);
  return root == 0 ? longest : std::min(longest, scaled_by_root(interval, root));
}

Interval next_interval(Interval interval, Ramp ramp, Interval longest) {
  if (ramp.mantissa == 0) return interval;
  // The mean rate of the interval, and by how much that at its end differs.
  const std::uint64_t mean = platform::divide(~std::uint64_t{0}, interval)
                             << interval_fraction_bits;
  constexpr int half_and_fraction_bits = interval_fraction_bits + 1;
  constexpr int early_bits = 8;  // so that the product fits
  const std::int64_t product = ramp.mantissa * static_cast<std::int64_t>(interval >> early_bits);
  const std::int64_t change = (product >> (half_and_fraction_bits - early_bits)) << ramp.shift;
  const std::uint64_t rate = mean + static_cast<std::uint64_t>(change);
  if (change < 0 && rate > mean) return longest;
  constexpr int acceleration_shift = acceleration_fraction_bits - ramp_fraction_bits;
  return first_interval(rate, std::int64_t{ramp.mantissa} << (ramp.shift + acceleration_shift),
                        longest);
}

}  // namespace software_stepping
