// SPDX-License-Identifier: Apache-2.0
// How often the main loop runs, how much a pass takes on, and how long the hardware waits for it:
// used by the tasks themselves, and by task_table.hpp to derive what must be done by when.
#pragma once

#include <cstddef>
#include <cstdint>

#include "units/quantity.hpp"

namespace application::task_timing {

// How long the loop sleeps if nothing wakes it.
inline constexpr units::Milliseconds sleep_at_work{2};
inline constexpr units::Milliseconds sleep_at_rest{8};

// Bytes that a pass takes from the uart at most.
inline constexpr std::size_t bytes_of_a_look = 128;
// The end of a line ends the sleep too, and so many bytes without one: half of that.
inline constexpr std::size_t wake_level = bytes_of_a_look / 2;

// No line is planned shorter. To hand one over takes about half of it, its registers included, and
// the queue, which holds 10 lines of three phases, lasts longer than any pass of the loop.
inline constexpr std::int64_t least_line_clocks = 16'000, fast_least_line_clocks = 9'600;
inline constexpr std::int64_t lines_of_a_pass = 10;

constexpr std::int64_t least_line(bool is_fast) {
  return is_fast ? fast_least_line_clocks : least_line_clocks;
}

// So many lines are handed over without a look at the serial line in between: they last longer in
// motion than it takes to receive a line, to answer it and to hand over the next, so that what has
// begun from rest does not run dry.
inline constexpr unsigned lines_without_look = 2;
// Lines that a pass hands over at most.
inline constexpr unsigned lines_handed_over = 32;

// A processor that hangs stops motion after this time: longer than any pass of the loop at 4 MHz.
inline constexpr units::Milliseconds motion_watchdog{200};

// The same of heat, and of sensors that are not read.
inline constexpr units::Milliseconds heater_watchdog{1'000};

}  // namespace application::task_timing
