// SPDX-License-Identifier: Apache-2.0
// Builds the firmware, and shows what bounds its functions have.
#include "tools/command/timing_job.hpp"

#include <algorithm>
#include <CLI/CLI.hpp>

#include "machine/machine.hpp"
#include "sim/processor/timing_table.hpp"
#include "tools/command/build.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/output.hpp"
#include "tools/command/task_times.hpp"
#include "tools/command/worst_inputs_job.hpp"
#include "tools/timing/machine_schedule.hpp"
#include "tools/timing/report.hpp"
#include "tools/timing/schedule_report.hpp"

namespace command {

void add_options(CLI::App& app, TimingOptions& options) {
  CLI::App& job =
      *app.add_subcommand("timing", "Bound the execution times of the firmware's functions.");
  CLI::Option* const functions =
      job.add_option("functions", options.functions, "as in the source; default: all")
          ->type_name("FUNCTION...");
  job.add_flag("--json", options.json, "write JSON instead of text");
  CLI::Option* const tasks =
      job.add_option(
             "--tasks", options.tasks,
             "co-simulate this print at 4 MHz, and list the tasks of the main loop: bound and "
             "longest time measured")
          ->type_name("FILE.gcode")
          ->check(CLI::ExistingFile)
          ->excludes(functions);
  job.add_flag("--schedule", options.schedule,
               "list which deadlines hold at which clock and baud rate, and the lowest clock")
      ->excludes(functions)
      ->excludes(tasks);
  job.add_option("--until", options.seconds, "of the print, in simulated seconds")
      ->check(CLI::Range(0.1, 100'000.0))
      ->capture_default_str()
      ->needs(tasks);
  CLI::Option* const search =
      job.add_option("--search", options.inputs,
                     "co-simulate so many inputs of a host, bred to make the tasks take long, and "
                     "list the longest time of each with its input")
          ->check(CLI::PositiveNumber)
          ->excludes(functions)
          ->excludes(tasks);
  job.add_option("--seed", options.seed, "of the search")->capture_default_str()->needs(search);
  job.add_option("--state", options.state,
                 "keep the search's state in this file, and go on with the one that is there")
      ->type_name("FILE")
      ->needs(search);
  job.footer(
      R"(Clocks from the first instruction to the return, with all that is called, without sleep.
A function without a bound is listed with the place, the reason and a remedy.
--tasks also adds up the clocks that the analysis gives to each instruction, and compares the sum
with mcycle.
--search shows its progress; Ctrl-C ends it with what it has found so far.

Exit status: 0 every function named has a bound, or none was named; 1 one has none, a task took
longer than its bound or its budget, an instruction took other clocks than the analysis says, or
there is a baud rate without a clock at which all deadlines hold; 2 bad usage or no such
function.)");
}

namespace {

int tasks_of(const timing::Program& program, const timing::Costs& costs,
             const TimingOptions& options) {
  const auto [rows, sum] = task_times(program, costs, options.tasks, options.seconds);
  say("{}", options.json ? timing::to_json(rows, sum) : timing::to_text(rows, tasks_clock_hz));
  if (!options.json) say("{}", sum.text());
  const bool holds = std::ranges::none_of(rows, [](const timing::TaskRow& row) {
    return row.measured.longest > std::min(row.bound.value_or(row.budget), row.budget);
  });
  return holds && sum.differences() == 0 ? success : failure;
}

int search(const timing::Program& program, const timing::Costs& costs,
           const TimingOptions& options) {
  const WorstInputs found = search_worst_inputs(
      program, costs, {.inputs = options.inputs, .seed = options.seed, .state = options.state});
  say("{}", options.json ? to_json(found) : to_text(found));
  return holds(found) ? success : failure;
}

int schedule_of(const timing::Program& program, const timing::Costs& costs, bool json) {
  const auto& machine = machine::machine;
  const auto facts = application::schedule_facts(machine.fast, machine.is_heavy());
  const auto schedule = timing::schedule_of(program, costs, CHIP_HAS_ZBB, facts);
  if (const auto left = timing::left_out(machine); !left.reason.empty() && !json) {
    say("of this machine not all that follows is proved: {}\n\n", left.reason);
  }
  say("{}", json ? timing::to_json(schedule) : timing::to_text(schedule));
  return timing::is_schedulable(schedule) ? success : failure;
}

}  // namespace

int timing_of(const TimingOptions& options) {
  build({"firmware"});
  timing::Program program = timing::read_program(build_folder() / "firmware" / "firmware.elf");
  program.memory_bytes = CHIP_MEMORY_BYTES;
  const timing::Costs costs{processor::TimingTable()};
  if (options.schedule) return schedule_of(program, costs, options.json);
  if (options.inputs != 0) return search(program, costs, options);
  if (!options.tasks.empty()) return tasks_of(program, costs, options);
  const auto rows = timing::bounds(program, costs, CHIP_HAS_ZBB, options.functions);
  say("{}", options.json ? timing::to_json(rows) : timing::to_text(rows));
  const bool all =
      std::ranges::all_of(rows, [](const timing::Row& row) { return row.clocks.has_value(); });
  return all || options.functions.empty() ? success : failure;
}

}  // namespace command
