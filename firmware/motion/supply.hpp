// SPDX-License-Identifier: Apache-2.0
// How fast lines come, and how long the next one must last so that motion slows down where they
// come too slowly, instead of stopping and starting again.
#pragma once

#include <cstddef>
#include <cstdint>

#include "units/quantity.hpp"

namespace motion {

// What is planned but not yet executed.
struct Stock {
  std::size_t lines{};  // in the planner's ring
  units::Microseconds time{};  // of these at their nominal speeds, and of what is handed over
  bool resting{};  // motion has not begun, or ends with what is handed over
};

class Supply {
 public:
  // So many lines, or so much time, is enough: the next line is not slowed down.
  static constexpr std::size_t enough_lines = 24;
  static constexpr units::Microseconds enough_time{100'000};
  // Where lines come slowly, the time of so many intervals.
  static constexpr std::int64_t enough_intervals = 8;
  // No line is slowed down to more than this, and a longer silence is a pause, not a slow supply.
  static constexpr units::Microseconds longest{100'000};

  // A line has come. `now` may run slower than real time where motion does.
  void line_came(units::Microseconds now);

  // The interval at which lines come, times a factor that depends on how much of `enough` is there:
  // 0 with all of it, 1 with two thirds, 2 with a third or less; from rest at most 1. So the stock
  // settles at two thirds where lines come too slowly. 0 where no interval is known.
  units::Microseconds least_time(const Stock& stock) const;

 private:
  std::uint32_t eighths_missing(const Stock& stock) const;

  units::Microseconds last_{};
  units::Microseconds interval_{};  // mean over some 8 lines; 0: unknown
  bool heard_{};
};

}  // namespace motion
