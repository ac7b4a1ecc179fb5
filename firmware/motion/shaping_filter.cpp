// SPDX-License-Identifier: Apache-2.0
// From impulses to weights of samples, and the sums.
#include "motion/shaping_filter.hpp"

#include <algorithm>

#include "motion/scaled.hpp"
#include "units/loop_bound.hpp"

namespace motion {

namespace {

constexpr std::size_t extruder = units::index_of(units::Axis::e);
constexpr int sum_fraction_bits = weight_fraction_bits + position_fraction_bits;

// The weights of samples at -1, 0, 1 and 2 for the value at `part` (2^-20) between 0 and 1, times
// `weight`: Lagrange's polynomials.
std::array<std::int32_t, 4> cubic(std::int32_t part, std::int32_t weight) {
  const auto product = [](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(std::int64_t{a} * b >> weight_fraction_bits);
  };
  const std::int32_t left = weight_one - part;
  const std::int32_t both = product(product(part, left), weight);
  const std::int32_t first = -product(both, weight_one + left) / 6;
  const std::int32_t fourth = -product(both, weight_one + part) / 6;
  // Their mean position is `part`.
  const std::int32_t third = product(part, weight) + first - 2 * fourth;
  return {first, weight - first - third - fourth, third, fourth};
}

// A period lasts six slots or more.
bool fits(const Shaper& shaper, units::Hertz clock, int slot_bits) {
  constexpr std::uint64_t least_slots = 6;
  return shaper.millihertz >= least_millihertz && shaper.millihertz <= most_millihertz &&
         (shaper.millihertz * least_slots << slot_bits) <= std::uint64_t{clock.count()} * 1000;
}

std::uint32_t slots_of(std::uint32_t clocks, int slot_bits) {
  return (clocks + (1u << slot_bits) - 1) >> slot_bits;
}

}  // namespace

void ShapingFilter::Taps::add(std::int32_t weight, std::uint32_t delay) {
  if (weight == 0) return;
  units::LoopBound<most_taps> looked_at;
  for (std::size_t i = 0; i < count; ++i) {
    looked_at.next();
    if (list[i].delay != delay) continue;
    list[i].weight += weight;
    return;
  }
  list[count++] = {.weight = weight, .delay = delay};
}

ShapingFilter::Taps ShapingFilter::taps_of(const Impulses& impulses, std::uint32_t slots_late,
                                           int slot_bits) {
  Taps taps;
  units::LoopBound<most_impulses> bound;
  for (std::size_t i = 0; i < impulses.count; ++i) {
    bound.next();
    const Impulse& impulse = impulses.list[i];
    const std::uint64_t clocks =
        (std::uint64_t{slots_late} << slot_bits) + impulse.delay - impulses.mean;
    const auto slot = static_cast<std::uint32_t>(clocks >> slot_bits);
    const std::uint64_t rest = clocks & ((std::uint64_t{1} << slot_bits) - 1);
    const auto part = static_cast<std::int32_t>(rest << weight_fraction_bits >> slot_bits);
    const auto weights = cubic(part, impulse.weight);
    units::LoopBound<taps_of_impulse, 1> added;
    for (std::uint32_t k = 0; k < weights.size(); ++k) {
      added.next();
      taps.add(weights[k], slot + k - 1);
    }
  }
  return taps;
}

bool ShapingFilter::configure(const ShapingSettings& settings, units::Hertz clock, int slot_bits) {
  std::array<Impulses, 2> impulses;
  constexpr std::uint32_t half_windows_per_second = 100;
  const std::uint32_t half_window =
      settings.advance_microseconds == 0
          ? 0
          : std::max<std::uint32_t>(clock.count() / half_windows_per_second >> slot_bits, 1);
  std::uint32_t late = half_window;
  units::LoopBound<shaped_axes> axes;
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    axes.next();
    const Shaper& shaper = settings.shapers[i];
    if (shaper.type != ShaperType::none && !fits(shaper, clock, slot_bits)) return false;
    impulses[i] = impulses_of(shaper, clock);
    if (shaper.type == ShaperType::none) continue;
    late = std::max(late, slots_of(impulses[i].mean, slot_bits) + 1);
  }
  std::uint32_t length = late + half_window;
  units::LoopBound<shaped_axes, 1> lengths;
  for (const Impulses& axis : impulses) {
    lengths.next();
    const std::uint32_t last = axis.list[axis.count - 1].delay - axis.mean;
    length = std::max(length, late + slots_of(last, slot_bits) + 1);
  }
  if (length >= capacity) return false;
  units::LoopBound<shaped_axes, 2> filters;
  for (std::size_t i = 0; i < taps_.size(); ++i) {
    filters.next();
    taps_[i] = taps_of(impulses[i], late, slot_bits);
  }
  slots_late_ = late;
  length_ = length;
  half_window_ = half_window;
  advance_ = 0;
  if (half_window == 0) return true;
  const Scaled windows = Scaled::of(std::uint64_t{settings.advance_microseconds} * clock.count()) /
                         Scaled::of(std::uint64_t{2'000'000} * half_window << slot_bits);
  advance_ = static_cast<std::int32_t>(windows.floor(weight_fraction_bits));
  return true;
}

units::PerAxis<std::int32_t> ShapingFilter::distance_from(
    const units::PerAxis<FinePosition>& here) const {
  const auto rounded = [](std::int64_t sum) {
    return static_cast<std::int32_t>((sum + (std::int64_t{1} << (sum_fraction_bits - 1))) >>
                                     sum_fraction_bits);
  };
  units::PerAxis<std::int32_t> result;
  const Sample& late = before(slots_late_);
  units::LoopBound<units::axis_count, 1> axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    axes.next();
    std::int64_t sum = 0;
    if (i < taps_.size()) {
      const Taps& taps = taps_[i];
      units::LoopBound<most_taps> added;
      for (std::size_t k = 0; k < taps.count; ++k) {
        added.next();
        const Tap& tap = taps.list[k];
        sum += std::int64_t{tap.weight} *
               static_cast<std::int32_t>(before(tap.delay).position[i] - here[i]);
      }
    } else {
      sum = static_cast<std::int64_t>(static_cast<std::int32_t>(late.position[i] - here[i])) *
            weight_one;
    }
    if (i == extruder && advance_ != 0) {
      const FinePosition ahead = before(slots_late_ - half_window_).printed;
      const FinePosition behind = before(slots_late_ + half_window_).printed;
      sum += std::int64_t{advance_} * static_cast<std::int32_t>(ahead - behind);
    }
    result[i] = rounded(sum);
  }
  return result;
}

}  // namespace motion
