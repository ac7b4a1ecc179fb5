// SPDX-License-Identifier: Apache-2.0
// What shapers and linear advance make of planned positions that are known once in each slot.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/shaper.hpp"
#include "motion/timeline.hpp"
#include "units/axes.hpp"
#include "units/quantity.hpp"

namespace motion {

struct ShapingSettings {
  std::array<Shaper, 2> shapers{};  // of X and Y
  std::uint32_t advance_microseconds{};  // of linear advance, 0 .. most_advance_microseconds

  bool any() const {
    return advance_microseconds != 0 || shapers[0].type != ShaperType::none ||
           shapers[1].type != ShaperType::none;
  }
  bool operator==(const ShapingSettings&) const = default;
};
inline constexpr std::uint32_t most_advance_microseconds = 10'000'000;

// Planned positions at the ends of slots, and of E what printing moves have added to it.
struct Sample {
  units::PerAxis<FinePosition> position{};
  FinePosition printed{};
};

// A sum of earlier samples for each axis, which is the convolution with the shaper's impulses:
// between samples a cubic through four of them is taken, so an impulse becomes four. All axes are
// late by the same time on average, a whole number of slots, so that what X and Y do fits to Z
// and E.
//
// Linear advance adds K times the mean speed of printing moves of E over 20 ms about the present:
// E has no steps to make at once where its speed jumps, and retractions stay as they are.
class ShapingFilter {
 public:
  static constexpr std::size_t capacity = 64;  // samples

  // False, and nothing done, where a mode is too fast for slots of 2^slot_bits clocks (a sixth of
  // their frequency is the limit) or too slow for the samples.
  bool configure(const ShapingSettings& settings, units::Hertz clock, int slot_bits);

  void push(const Sample& sample) {
    samples_[++newest_ % capacity] = sample;
    pushed_ = std::min(pushed_ + 1, capacity);
  }
  // All samples become this one, at once: a stop does not wait for that.
  void fill(const Sample& sample) {
    filled_with_ = sample;
    pushed_ = 0;
  }

  // How far each axis is to go from `here` (2^-8 step) to where it is to be, in steps, rounded.
  units::PerAxis<std::int32_t> distance_from(const units::PerAxis<FinePosition>& here) const;

  // In samples: by which all axes are late, and over which the speed of E is taken.
  std::uint32_t slots_late() const { return slots_late_; }
  std::uint32_t speed_window() const { return 2 * half_window_; }
  // So many samples after the last change the axes are where the newest sample is.
  std::uint32_t length() const { return length_; }

 private:
  struct Tap {
    std::int32_t weight{};  // 2^-20
    std::uint32_t delay{};  // samples
  };
  static constexpr std::size_t taps_of_impulse = 4, most_taps = most_impulses * taps_of_impulse;
  struct Taps {
    std::array<Tap, most_taps> list{};
    std::size_t count{};

    void add(std::int32_t weight, std::uint32_t delay);
  };

  static constexpr std::size_t shaped_axes = 2;
  static Taps taps_of(const Impulses& impulses, std::uint32_t slots_late, int slot_bits);
  const Sample& before(std::uint32_t samples) const {
    return samples < pushed_ ? samples_[(newest_ - samples) % capacity] : filled_with_;
  }

  std::array<Sample, capacity> samples_{};
  Sample filled_with_{};  // before those that have been pushed
  std::size_t pushed_{};
  std::uint32_t newest_{};
  std::array<Taps, shaped_axes> taps_{};
  std::uint32_t slots_late_{};
  std::uint32_t length_{};
  std::uint32_t half_window_{};  // slots on either side over which E's speed is taken
  std::int32_t advance_{};  // weight of what is printed within both
};

}  // namespace motion
