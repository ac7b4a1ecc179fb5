// SPDX-License-Identifier: Apache-2.0
// The apex of a ramp of third order, and the segments before and behind it.
#include "motion/s_curve.hpp"

#include <algorithm>

namespace motion {

namespace {

constexpr int rate_fraction_bits = 64;
constexpr int acceleration_fraction_bits = 84;
constexpr int apex_bits = 32;
// From a rate's unit to that of accelerations and jerks.
constexpr int finer_bits = acceleration_fraction_bits - rate_fraction_bits;
constexpr Scaled three = Scaled::of_word(3);

Scaled twice(Scaled value) { return Scaled::of_parts(value.mantissa(), value.exponent() + 1); }

}  // namespace

SCurve::SCurve(std::uint32_t ticks, std::uint64_t from, std::uint64_t to, std::uint32_t apex)
    : ticks_(ticks),
      apex_(apex),
      rises_(to > from),
      from_(from),
      slow_(std::min(from, to)),
      change_(Scaled::of(std::max(from, to) - slow_)) {}

std::optional<SCurve> SCurve::between(std::uint32_t ticks, std::uint64_t from, std::uint64_t to) {
  if (ticks < least_ticks || from == to) return std::nullopt;
  const Scaled mean = Scaled::of(from / 2 + to / 2);
  const std::uint64_t clocks = (Scaled::of_word(ticks, rate_fraction_bits) / mean).floor();
  if (clocks < least_clocks || clocks > most_clocks) return std::nullopt;
  SCurve curve(ticks, from, to, 0);
  curve.apex_ = curve.apex_of_slow_ticks();
  return curve;
}

// k: with u = 1/2 it is n (6 a + d) / (6 (2 a + d)).
std::uint32_t SCurve::slow_ticks() const {
  const Scaled two_slow = twice(Scaled::of(slow_));
  const Scaled part = (three * two_slow + change_) / (twice(three) * (two_slow + change_));
  return part.floor_of_product(ticks_, 0) + 1;
}

// The root of d u^2 + (3 a + d k/n) u = (3 a + 2 d) k/n, in the form whose terms are all positive.
std::uint32_t SCurve::apex_of_slow_ticks() const {
  const Scaled three_slow = three * Scaled::of(slow_);
  const Scaled all = Scaled::of_word(ticks_);
  const Scaled slow_side = Scaled::of_word(slow_ticks());
  const Scaled linear = three_slow * all + change_ * slow_side;
  const Scaled constant = (three_slow + twice(change_)) * slow_side;
  const Scaled four_products = twice(twice(change_ * all * constant));
  const Scaled root = (linear * linear + four_products).square_root();
  const std::uint64_t apex = (twice(constant) / (linear + root)).floor(apex_bits);
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(apex, 0xFFFF'FFFE));
}

// 3 a + d (2 - u), in 2^-64.
Scaled SCurve::three_means() const {
  const std::uint64_t two_less_apex = (std::uint64_t{2} << apex_bits) - apex_;
  return three * Scaled::of(slow_) + change_ * Scaled::of(two_less_apex, -apex_bits);
}

std::uint64_t SCurve::clocks() const {
  return (three * Scaled::of_word(ticks_, rate_fraction_bits) / three_means()).floor();
}

// The hardware adds in the order phase, rate, acceleration. A course R + A t + J t^2 / 2 is met at
// every clock by a first rate of R + A / 2 + J / 6 and a first acceleration of A + J.
void SCurve::set_half(bool second, Segment& segment) const {
  const bool slow_side = rises_ != second;
  const Scaled per_clock =
      three_means() / (three * Scaled::of_word(ticks_, rate_fraction_bits));  // 1 / T
  const Scaled highest = twice(change_) * per_clock;
  const std::uint32_t part = slow_side ? apex_ : 0 - apex_;  // of T
  const auto jerk_size = static_cast<std::int64_t>(
      (highest * per_clock / Scaled::of_word(part, -apex_bits)).floor(finer_bits));
  const std::uint32_t on_slow_side = slow_ticks();
  segment.ticks = slow_side ? on_slow_side : ticks_ - on_slow_side;

  const std::uint64_t to_apex = (change_ * Scaled::of_word(apex_, -apex_bits)).floor();
  const std::uint64_t first = second ? slow_ + to_apex : from_;
  const auto highest_size = static_cast<std::int64_t>(highest.floor(finer_bits));
  const std::int64_t acceleration = !second ? 0 : rises_ ? highest_size : -highest_size;
  segment.jerk = slow_side ? jerk_size : -jerk_size;
  segment.acceleration = acceleration + segment.jerk;
  segment.rate =
      first + static_cast<std::uint64_t>((acceleration + segment.jerk / 3) >> (finer_bits + 1));
}

}  // namespace motion
