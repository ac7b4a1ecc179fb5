// SPDX-License-Identifier: Apache-2.0
// Stepping of other systems, as they publish it: one axis at the highest rate.
#pragma once

#include <array>

namespace benchmarks {

struct PublishedFigure {
  const char* system;
  double clock_mhz;
  double clocks_per_step;
  const char* remark;
  const char* source;

  constexpr double steps_per_second() const { return clock_mhz * 1e6 / clocks_per_step; }
  constexpr double steps_per_million_clocks() const { return 1e6 / clocks_per_step; }
};

inline constexpr const char* klipper = "https://www.klipper3d.org/Benchmarks.html";

inline constexpr std::array<PublishedFigure, 4> published_figures{{
    {"Klipper, ATmega", 16, 102, "in a simulator", klipper},
    {"Klipper, STM32H723", 520, 61, "a step on both edges", klipper},
    {"Klipper, STM32F446", 180, 46, "a step on both edges", klipper},
    {"Klipper, RP2350", 150, 36, "a step on both edges", klipper},
}};

}  // namespace benchmarks
