// SPDX-License-Identifier: Apache-2.0
// The schedule as a text and as JSON: which requirements hold at which clock and baud rate, and the
// lowest clock at which all do.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tools/timing/tasks.hpp"

namespace timing {

// Clocks for which the table is made, and rates of the serial line for which there is an image:
// tools/machine_generator/CMakeLists.txt has them.
inline constexpr std::uint32_t table_clocks_hz[] = {4'000'000, 8'000'000, 25'000'000, 50'000'000};
std::vector<std::uint32_t> offered_baud_rates();

struct Schedule {
  Facts facts;
  Load load;
  std::vector<TaskRow> rows;
  std::set<Problem> problems;  // why something has no bound
};

// Of the image. Throws std::runtime_error where it lacks marks, or enables interrupts.
Schedule schedule_of(const Program& program, const Costs& costs, bool has_zbb, const Facts& facts);

// "the task reports at intervals has no bound", for each that has none, for the pass, and for what
// else the load is of.
std::vector<std::string> missing_bounds(const Schedule& schedule);

// A pass of nothing but the tasks that have a bound: what it misses, the whole one misses too.
Load bounded_part(const std::vector<TaskRow>& rows);

// What is missed at one rate. Where the pass has no bound, only what those tasks that have one miss
// by themselves.
std::vector<Response> misses(const Schedule& schedule, Rate rate);

// Everything has a bound, and at each offered baud rate there is a clock at which all holds.
bool is_schedulable(const Schedule& schedule);

// "lowest clock 4000000 Hz (REQUIREMENT)", or why there is none.
std::string to_text(const ClockRange& range);
std::string to_text(const Schedule& schedule);
std::string to_json(const Schedule& schedule);

}  // namespace timing
