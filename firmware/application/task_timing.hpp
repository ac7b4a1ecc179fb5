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

// Bytes that a pass takes from the uart at most: those of the longest line, and its end. It takes
// no more than one line.
inline constexpr std::size_t bytes_of_a_look = 129;
// The end of a line ends the sleep too, and so many bytes without one: half of that.
inline constexpr std::size_t wake_level = bytes_of_a_look / 2;

// No line is planned shorter. To hand one over takes about half of it, its registers included, and
// the queue, which holds 10 lines of three phases, lasts longer than any pass of the loop.
inline constexpr std::int64_t least_line_clocks = 16'000, fast_least_line_clocks = 9'600;
inline constexpr std::int64_t lines_of_a_pass = 10;

// A sixteenth more for two extruders and for CoreXY, which plan and hand over a line in a little
// more time: with it grow what is in hand, and what tasks may take of it.
constexpr std::int64_t least_line(bool is_fast, bool is_heavy) {
  const std::int64_t light = is_fast ? fast_least_line_clocks : least_line_clocks;
  return is_heavy ? light + light / 16 : light;
}

// Lines that a pass hands over at most.
inline constexpr unsigned lines_of_a_refill = 4;
// In place of each, slots where motion is shaped.
inline constexpr unsigned shaped_slots = 3;

// While motion goes on into lines that wait, a task begins only if what is in hand outlasts its
// allowance (task_table.hpp) and this: until the next line is handed over, and what follows.
inline constexpr std::int64_t refill_reserve = 26'000;
// When the pass behind a refill gets to the task that waits, no more than this is missing of what
// the refill is to have in hand: the time of a line that filled the queue, and of a pass.
inline constexpr std::int64_t refill_margin = 25'000;
// Lines that the tasks of a round append at most: a chord or a move of homing, and a command's.
inline constexpr std::int64_t lines_of_a_round = 2;

// A processor that hangs stops motion after this time: longer than any pass of the loop at 4 MHz.
inline constexpr units::Milliseconds motion_watchdog{200};

// The same of heat, and of sensors that are not read.
inline constexpr units::Milliseconds heater_watchdog{1'000};
// It is not fed sooner after the last time: a sixteenth of that would be too early for it, and what
// the heaters' task takes comes on top.
inline constexpr units::Milliseconds least_heat_period{90};

}  // namespace application::task_timing
