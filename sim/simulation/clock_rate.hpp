// SPDX-License-Identifier: Apache-2.0
// Conversion between clocks and seconds at the chip's clock frequency.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/simulation/pins.hpp"

namespace sim {

class ClockRate {
 public:
  explicit constexpr ClockRate(std::uint32_t hertz) : hertz_(hertz) {}

  constexpr std::uint32_t hertz() const { return hertz_; }
  constexpr double seconds(Clock clocks) const {
    return static_cast<double>(clocks) / static_cast<double>(hertz_);
  }
  Clock clocks(double seconds) const {
    return static_cast<Clock>(std::llround(seconds * static_cast<double>(hertz_)));
  }
  // The fewest clocks that last at least so many nanoseconds.
  constexpr Clock clocks_covering_ns(std::uint64_t nanoseconds) const {
    return (nanoseconds * hertz_ + 999'999'999) / 1'000'000'000;
  }

 private:
  std::uint32_t hertz_;
};

}  // namespace sim
