// SPDX-License-Identifier: Apache-2.0
// Watches step and direction pins as a motor driver does: counts pulses and measures their times.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace tests {

class PulseRecorder {
 public:
  static constexpr std::size_t axes = 5;
  static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

  // In clocks.
  struct Axis {
    std::int64_t forward{}, backward{};
    std::uint64_t shortest_high{never}, shortest_low{never};
    std::uint64_t shortest_period{never}, longest_period{0};
    std::uint64_t shortest_setup{never}, shortest_hold{never};
  };

  // In every clock.
  void watch(std::uint64_t clock, std::uint32_t step, std::uint32_t direction) {
    if (step == step_ && direction == direction_) return;
    for (std::size_t i = 0; i < axes; ++i) {
      const bool is_high = (step >> i & 1u) != 0, was_high = (step_ >> i & 1u) != 0;
      const bool backward = (direction >> i & 1u) != 0;
      if (backward != ((direction_ >> i & 1u) != 0)) note_turn(i, clock);
      if (is_high && !was_high) note_rise(i, clock, backward);
      if (!is_high && was_high) note_fall(i, clock);
    }
    step_ = step;
    direction_ = direction;
  }

  const Axis& axis(std::size_t index) const { return axis_[index]; }

  std::array<std::int64_t, axes> counts() const {
    std::array<std::int64_t, axes> result{};
    for (std::size_t i = 0; i < axes; ++i) result[i] = axis_[i].forward + axis_[i].backward;
    return result;
  }

 private:
  struct Times {
    std::optional<std::uint64_t> rose, fell, turned;
  };

  static void lessen(std::uint64_t& least, std::optional<std::uint64_t> since,
                     std::uint64_t clock) {
    if (since) least = std::min(least, clock - *since);
  }

  void note_rise(std::size_t i, std::uint64_t clock, bool backward) {
    Axis& axis = axis_[i];
    Times& times = times_[i];
    (backward ? axis.backward : axis.forward)++;
    lessen(axis.shortest_low, times.fell, clock);
    lessen(axis.shortest_period, times.rose, clock);
    lessen(axis.shortest_setup, times.turned, clock);
    if (times.rose) axis.longest_period = std::max(axis.longest_period, clock - *times.rose);
    times.rose = clock;
  }

  void note_fall(std::size_t i, std::uint64_t clock) {
    lessen(axis_[i].shortest_high, times_[i].rose, clock);
    times_[i].fell = clock;
  }

  void note_turn(std::size_t i, std::uint64_t clock) {
    lessen(axis_[i].shortest_hold, times_[i].rose, clock);
    times_[i].turned = clock;
  }

  std::array<Axis, axes> axis_{};
  std::array<Times, axes> times_{};
  std::uint32_t step_ = 0, direction_ = 0;
};

}  // namespace tests
