// SPDX-License-Identifier: Apache-2.0
// Step and direction timing of motor drivers from their data sheets, in clocks of 50 MHz.
#pragma once

#include <array>
#include <cstdint>

namespace benchmarks {

struct DriverGuard {
  const char* driver;
  // Step high and low; direction before and after the rising edge.
  std::uint32_t high{1}, low{1}, setup{1}, hold{1};

  // Between two ticks, at least.
  constexpr std::uint32_t shortest_interval() const { return high + low; }
};

inline constexpr DriverGuard no_driver{.driver = "guard 1"};

inline constexpr std::array<DriverGuard, 3> real_drivers{{
    {.driver = "A4988", .high = 50, .low = 50, .setup = 10, .hold = 10},
    {.driver = "DRV8825", .high = 95, .low = 95, .setup = 33, .hold = 33},
    {.driver = "TMC2209", .high = 6, .low = 6, .setup = 2, .hold = 2},
}};

}  // namespace benchmarks
