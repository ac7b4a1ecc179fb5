// SPDX-License-Identifier: Apache-2.0
// Which clock the simulated chip may have so that its printer keeps up with the clock on the wall.
#pragma once

#include <cstdint>

#include "tools/command/print_job.hpp"

namespace command {

// A slow chip that keeps up with the wall's clock serves a host better than a fast one that does
// not: it makes the same pulses, and hosts wait for signs of life in wall time.
inline constexpr std::uint32_t lowest_serve_clock_hz = 2'000'000;

struct ClockChoice {
  std::uint32_t clock_hz{};
  // Of this machine, for the chip while it prints short moves as fast as it can plan them.
  double model_clocks_per_second{};
};

// Prints for about a second of wall time on a chip of its own. The clock is the highest round
// one that leaves a quarter of the model's speed over, and not below `lowest_serve_clock_hz`
// even where this machine does not reach that. Builds the firmware; throws std::runtime_error
// where that fails.
ClockChoice clock_that_keeps_up(const PrinterChoices& choices);

}  // namespace command
