// SPDX-License-Identifier: Apache-2.0
// The chip with its firmware on the simulated printer for some milliseconds, in intervals.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/replay/interval.hpp"

namespace tests {

inline constexpr std::uint32_t recorded_clock_hz = 4'000'000;

// With heat, a fan, motion, and noise on a switch, from reset on. `length` is that of an interval
// at least.
std::vector<replay::Interval> recorded_run(sim::Clock clocks, sim::Clock length);

}  // namespace tests
