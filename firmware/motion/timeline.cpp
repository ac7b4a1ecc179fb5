// SPDX-License-Identifier: Apache-2.0
// Times and parabolas of segments, in integers.
#include "motion/timeline.hpp"

#include <algorithm>
#include <bit>

#include "motion/scaled.hpp"
#include "units/magnitude.hpp"

namespace motion {

namespace {

constexpr int rate_fraction_bits = 64;
constexpr int acceleration_fraction_bits = 84;
// As in profile.cpp: rates are given with half an acceleration more.
constexpr int half_acceleration_shift = acceleration_fraction_bits - rate_fraction_bits + 1;
constexpr std::uint64_t highest_rate = std::uint64_t{1} << 63;

// sqrt(rate^2 + 2 acceleration ticks), in 2^-64; not below 0.
std::uint64_t end_rate(std::uint64_t rate, std::int64_t acceleration, std::uint32_t ticks) {
  const std::uint64_t size = units::magnitude(acceleration);
  const Scaled first = Scaled::of(rate, -rate_fraction_bits);
  const Scaled change = Scaled::of(size, 1 - acceleration_fraction_bits) * Scaled::of(ticks);
  // Both below 2^62 of so many binary places.
  const int square_bits = 2 * (static_cast<int>(std::bit_width(rate)) - rate_fraction_bits);
  const int change_bits = static_cast<int>(std::bit_width(size) + std::bit_width(ticks)) + 1 -
                          acceleration_fraction_bits;
  const int places = 62 - std::max(square_bits, change_bits);
  const std::uint64_t before = (first * first).floor(places);
  const std::uint64_t by = change.floor(places);
  const std::uint64_t after = acceleration > 0 ? before + by : before - std::min(before, by);
  return std::min(Scaled::of(after, -places).square_root().floor(rate_fraction_bits), highest_rate);
}

}  // namespace

void Timeline::begin(const Segment& segment) {
  if (segment.continues_line) {
    ticks_before_ += ticks_;
  } else {
    begin_line(segment);
  }
  ticks_ = segment.ticks;
  set_time(segment);
}

void Timeline::begin_line(const Segment& segment) {
  start_ = end();
  steps_ = segment.steps;
  line_ticks_ = segment.line_ticks;
  ticks_before_ = 0;
  const Scaled ticks = Scaled::of(line_ticks_);
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const std::uint32_t size = units::magnitude(steps_[i]);
    part_[i] = size == line_ticks_
                   ? 1u << 31
                   : static_cast<std::uint32_t>((Scaled::of(size, 31) / ticks).floor());
  }
  prints_ = steps_[units::index_of(units::Axis::e)] > 0 &&
            (steps_[units::index_of(units::Axis::x)] != 0 ||
             steps_[units::index_of(units::Axis::y)] != 0);
}

void Timeline::set_time(const Segment& segment) {
  const auto half_acceleration =
      static_cast<std::uint64_t>(segment.acceleration >> half_acceleration_shift);
  const std::uint64_t first = std::min(segment.rate - half_acceleration, highest_rate);
  const std::uint64_t last =
      segment.acceleration == 0 ? first : end_rate(first, segment.acceleration, ticks_);
  const std::uint64_t mean = std::max<std::uint64_t>(first / 2 + last / 2, 1);
  clocks_ = std::max<std::uint64_t>(
      (Scaled::of(ticks_, rate_fraction_bits) / Scaled::of(mean)).floor(), 1);
  first_rate_ = static_cast<std::uint32_t>(
      std::min<std::uint64_t>((Scaled::of(first) / Scaled::of(mean)).floor(30), 0x7FFF'FFFF));
  bits_ = static_cast<std::uint8_t>(std::bit_width(clocks_));
  inverse_ = static_cast<std::uint32_t>(std::min<std::uint64_t>(
      (Scaled::of(1, 31 + bits_) / Scaled::of(clocks_)).floor(), 0xFFFF'FFFF));
}

// With x = elapsed / clocks and the first rate f in parts of the mean one, the part
// f x + (1 - f) x^2 = x (f (1 - x) + x) of the ticks is made.
units::PerAxis<FinePosition> Timeline::at(std::uint64_t elapsed) const {
  if (elapsed >= clocks_) return end();
  constexpr std::uint32_t one = 1u << 31;
  const auto left_aligned =
      static_cast<std::uint32_t>(bits_ > 32 ? elapsed >> (bits_ - 32) : elapsed << (32 - bits_));
  const auto time =
      std::min(static_cast<std::uint32_t>(std::uint64_t{left_aligned} * inverse_ >> 32), one);
  const std::uint64_t slope = (std::uint64_t{first_rate_} * (one - time) >> 30) + time;
  const std::uint64_t part = std::uint64_t{time} * static_cast<std::uint32_t>(slope) >> 31;
  return after((std::uint64_t{ticks_before_} << 31) + ticks_ * part);
}

units::PerAxis<FinePosition> Timeline::end() const {
  const std::uint32_t ticks = ticks_before_ + ticks_;
  if (ticks != line_ticks_) return after(std::uint64_t{ticks} << 31);
  units::PerAxis<FinePosition> position = start_;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    position[i] += static_cast<FinePosition>(steps_[i]) << position_fraction_bits;
  }
  return position;
}

units::PerAxis<FinePosition> Timeline::after(std::uint64_t ticks_31) const {
  const auto whole = static_cast<std::uint32_t>(ticks_31 >> 31);
  const auto rest = static_cast<std::uint32_t>(ticks_31) & 0x7FFF'FFFF;
  units::PerAxis<FinePosition> position = start_;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const std::uint64_t moved =
        std::uint64_t{part_[i]} * whole + (std::uint64_t{part_[i]} * rest >> 31);
    const auto fine = static_cast<FinePosition>(moved >> (31 - position_fraction_bits));
    position[i] += steps_[i] < 0 ? -fine : fine;
  }
  return position;
}

}  // namespace motion
