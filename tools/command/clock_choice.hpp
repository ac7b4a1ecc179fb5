// SPDX-License-Identifier: Apache-2.0
// The clock frequency at which the simulated chip keeps up with real time.
#pragma once

#include <cstdint>

#include "tools/command/print_job.hpp"

namespace command {

// A slow chip that keeps up with real time serves a host better than a fast one that does not: it
// makes the same pulses, and the time-outs of hosts run in real time.
inline constexpr std::uint32_t lowest_serve_clock_hz = 2'000'000;

struct ClockChoice {
  std::uint32_t clock_hz{};
  // Speed of the model on this machine, while the chip prints short moves as fast as it can
  // plan them.
  double model_clocks_per_second{};
};

// Prints for about a second of wall time on a chip of its own. The clock is the highest round
// one that leaves a quarter of the model's speed over, and not below `lowest_serve_clock_hz`
// even where this machine does not reach that. Builds the firmware; throws std::runtime_error
// where that fails.
ClockChoice clock_that_keeps_up(const PrinterChoices& choices);

}  // namespace command
