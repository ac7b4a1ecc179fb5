// SPDX-License-Identifier: Apache-2.0
// The tasks of the main loop and what they must not miss. From this table come the page tasks.md,
// the analysis of the schedule (tools/timing) and the check of the times that are measured.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "application/task_timing.hpp"
#include "host_link/host_link.hpp"
#include "motion/planner.hpp"
#include "registers/heater_control_registers.hpp"
#include "registers/uart_registers.hpp"
#include "thermal/heater_loop.hpp"
#include "units/task_span.hpp"

namespace application {

// By the first of these that is over; what is 0 does not count.
struct Deadline {
  units::Milliseconds time{};
  std::int64_t clocks{};
  std::uint32_t bytes{};  // on the serial line
};

struct TaskRow {
  units::Task task;
  std::string_view name;
  units::Milliseconds period;  // 0: each pass
  Deadline deadline;
  std::uint32_t budget;  // clocks
  std::uint32_t allowance;  // clocks; what must be in hand for it, 0: it never waits
  std::uint8_t priority;  // 1 comes first in a pass
  std::string_view reason;  // of the deadline
};

// M112 has stopped motion and heat after this time at the slowest clock, however many lines come
// before it. What must be faster has the emergency stop input: hardware, which needs no program.
inline constexpr units::Milliseconds stop_by_host_within{1500};
// Faults that software alone detects; stops are settled.
inline constexpr units::Milliseconds stop_within{1000};

inline constexpr std::array<TaskRow, units::task_count> task_table{{
    {.task = units::Task::motion,
     .name = "motion: sign of life",
     .period = {},
     .deadline = {.time = task_timing::motion_watchdog},
     .budget = 1'000,
     .allowance = 0,
     .priority = 1,
     .reason = "motion's watchdog stops all axes"},
    {.task = units::Task::serial_line,
     .name = "serial line: a line in, its answer",
     .period = {},
     .deadline = {.time = host_link::HostLink::longest_silence,
                  .bytes = registers::uart::receive_depth},
     .budget = 40'000,
     .allowance = 49'000,
     .priority = 2,
     .reason = "the FIFO of received bytes is full; a host hears nothing; M112 waits"},
    {.task = units::Task::faults,
     .name = "faults",
     .period = {},
     .deadline = {.time = stop_within},
     .budget = 6'000,
     .allowance = 14'000,
     .priority = 3,
     .reason = "motion and heat go on after a fault that software alone detects"},
    {.task = units::Task::heat,
     .name = "heat: sensors, heaters",
     .period = thermal::HeaterLoop::period,
     .deadline = {.time = task_timing::heater_watchdog},
     .budget = 32'000,
     .allowance = 45'000,
     .priority = 4,
     .reason = "the heaters' watchdog opens their supply, also where it is fed too early"},
    {.task = units::Task::planning,
     .name = "planning: stops, chords, homing",
     .period = {},
     .deadline = {.time = stop_within},
     .budget = 12'000,
     .allowance = 16'000,
     .priority = 5,
     .reason = "a stop is not settled; homing waits"},
    {.task = units::Task::reports,
     .name = "reports at intervals",
     .period = units::Milliseconds(100),
     .deadline = {},
     .budget = 12'000,
     .allowance = 20'000,
     .priority = 6,
     .reason = ""},
    {.task = units::Task::commands,
     .name = "commands: one of them",
     .period = {},
     .deadline = {.time = host_link::HostLink::longest_silence},
     .budget = 40'000,
     .allowance = 82'000,
     .priority = 7,
     .reason = "a host hears nothing"},
    {.task = units::Task::refill,
     .name = "refill: segments to the step generator",
     .period = {},
     .deadline = {.time = units::Milliseconds(motion::Planner::horizon.count() / 1000),
                  .clocks = task_timing::lines_of_a_pass * task_timing::least_line_clocks},
     .budget = 24'000,
     .allowance = 0,
     .priority = 8,
     .reason = "motion that has been handed over ends"},
    {.task = units::Task::rest,
     .name = "rest: watchdog's second key, counters",
     .period = {},
     .deadline = {.time = task_timing::heater_watchdog},
     .budget = 4'000,
     .allowance = 0,
     .priority = 9,
     .reason = "the heaters' watchdog opens their supply"},
}};

// The table is in the order of the pass, which is that of its priorities.
static_assert([] {
  for (std::size_t i = 0; i < task_table.size(); ++i) {
    if (static_cast<std::size_t>(task_table[i].task) != i) return false;
    if (task_table[i].priority != i + 1) return false;
    if (!task_table[i].name.starts_with(units::task_names[i])) return false;
  }
  return true;
}());

// What must be in hand for a task, in parts of what a refill is to have in hand: that is shorter on
// a fast machine, and so are its tasks.
inline constexpr std::uint32_t whole_need = 256;
constexpr std::uint8_t part_of(std::int64_t clocks) {
  constexpr std::int64_t whole = task_timing::lines_of_a_pass * task_timing::least_line_clocks;
  return static_cast<std::uint8_t>((clocks * whole_need + whole - 1) / whole);
}
constexpr std::uint8_t part_of(units::Task task) {
  const std::uint32_t allowance = task_table[static_cast<std::size_t>(task)].allowance;
  return part_of(allowance + task_timing::refill_reserve);
}

// Each task has its turn.
static_assert([] {
  for (const TaskRow& row : task_table) {
    const std::uint32_t part = part_of(row.task);
    if (part + part_of(task_timing::refill_margin) > whole_need) return false;
  }
  return true;
}());

// The pass ends behind these where they have had anything to do, behind reports also where a task
// before has; the next one goes on with the round of tasks.
constexpr bool ends_pass(units::Task task) {
  return task == units::Task::heat || task == units::Task::reports || task == units::Task::commands;
}
inline constexpr std::uint64_t passes_of_a_round = [] {
  std::uint64_t passes = 0;
  for (const TaskRow& row : task_table) {
    if (ends_pass(row.task)) ++passes;
  }
  return passes;
}();

// What the deadlines follow from: each number from where the task or the hardware has it.
struct ScheduleFacts {
  // Serial line.
  std::uint64_t receive_depth = registers::uart::receive_depth;
  std::uint64_t bytes_of_a_look = task_timing::bytes_of_a_look;
  std::uint64_t frame_bits = 10;  // start bit, 8 data bits, stop bit
  std::uint64_t fast_sender_percent =
      103;  // the receiver follows no faster one (uart_receiver.vhd)
  std::uint64_t bytes_of_a_line = host_link::max_line_length + 2;  // both line ends
  // A host sends no more before it has an answer: the lines of the queue, and one that needs no
  // turn, such as M112.
  std::uint64_t unanswered_lines = host_link::LineQueue::capacity + 1;
  std::uint64_t busy_message_bytes = host_link::HostLink::longest_busy_message;
  std::uint64_t busy_lead_ms = host_link::HostLink::busy_lead.count();
  std::uint64_t stop_by_host_within_ms = stop_by_host_within.count();
  std::uint64_t stop_within_ms = stop_within.count();
  // The loop's sleep.
  std::uint64_t sleep_ms = task_timing::sleep_at_rest.count();
  // Motion.
  std::uint64_t horizon_ms = motion::Planner::horizon.count() / 1000;
  std::uint64_t least_line_clocks = task_timing::least_line_clocks;
  std::uint64_t lines_of_a_pass = task_timing::lines_of_a_pass;
  std::uint64_t lines_of_a_refill = task_timing::lines_of_a_refill;
  std::uint64_t refill_reserve = task_timing::refill_reserve;
  std::uint64_t refill_margin = task_timing::refill_margin;
  std::array<std::uint64_t, units::task_count> allowances = [] {
    std::array<std::uint64_t, units::task_count> clocks{};
    for (std::size_t i = 0; i < clocks.size(); ++i) clocks[i] = task_table[i].allowance;
    return clocks;
  }();
  // The ring's, and one that has begun.
  std::uint64_t waiting_lines = motion::Planner::capacity + 1;
  std::uint64_t lines_of_a_round = task_timing::lines_of_a_round;
  std::uint64_t motion_watchdog_ms = task_timing::motion_watchdog.count();
  // Heat.
  std::uint64_t heat_period_ms = thermal::HeaterLoop::period.count();
  std::uint64_t least_heat_ms = task_timing::least_heat_period.count();
  std::uint64_t heater_watchdog_ms = task_timing::heater_watchdog.count();
  std::uint64_t early_part = 16;  // of the watchdog's time is too early (feed_watchdog.vhd)
  std::uint64_t heater_tick_clocks = registers::heater_control::tick_cycles;
};

constexpr ScheduleFacts schedule_facts(bool is_fast, bool is_heavy) {
  ScheduleFacts facts;
  const auto least = static_cast<std::uint64_t>(task_timing::least_line(is_fast, is_heavy));
  const auto shortened = [&](std::uint64_t& clocks) {
    clocks = clocks * least / task_timing::least_line_clocks;
  };
  facts.least_line_clocks = least;
  for (std::uint64_t& allowance : facts.allowances) shortened(allowance);
  shortened(facts.refill_reserve);
  shortened(facts.refill_margin);
  return facts;
}

// A host that waits for its answers cannot fill the FIFO.
static_assert(ScheduleFacts().unanswered_lines * ScheduleFacts().bytes_of_a_line <=
              ScheduleFacts().receive_depth);
// A look takes the longest line, but for a second byte of its end.
static_assert(ScheduleFacts().bytes_of_a_line - 1 <= ScheduleFacts().bytes_of_a_look);

}  // namespace application
