// SPDX-License-Identifier: Apache-2.0
// A print clock by clock, each call of a function with its time.
#include "tools/command/task_times.hpp"

#include <stdexcept>

#include "sim/devices/file_host.hpp"
#include "sim/devices/gcode_file.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/signals.hpp"
#include "tools/command/warm_start.hpp"

namespace command {

namespace {

constexpr std::size_t lines_in_flight = 4;

}  // namespace

TaskTimes task_times(const timing::Program& program, const timing::Costs& costs,
                     const std::filesystem::path& file, double seconds) {
  const auto commands = devices::read_gcode_file(file);
  if (!commands) throw std::runtime_error(commands.error());
  PrinterChoices choices;
  choices.clock_hz = tasks_clock_hz;
  choices.warm = true;
  PrinterSetup setup(choices, near_first_targets(*commands, description_of(choices)));
  sim::Simulation& simulation = setup.simulation();
  devices::FileHost host(*commands, setup.printer().serial_line(), simulation.rate(),
                         {.window = lines_in_flight, .answers_prompts = true, .note = {}});
  simulation.attach(host, {}, sim::Activity::host_and_report);

  timing::Analysis analysis(program, costs, CHIP_HAS_ZBB);
  timing::Calls calls(program, CHIP_HAS_ZBB);
  timing::watch_tasks(program, analysis, calls);
  timing::CostSum sum(program, costs, CHIP_HAS_ZBB);
  const sim::Clock until = simulation.rate().clocks(seconds);
  while (simulation.now() < until && !host.ended()) {
    simulation.run_until(simulation.now() + 1);
    const timing::Sample sample = timing::sample_of(setup.chip().processor_statistics());
    calls.take(sample);
    sum.take(sample);
    end_if_interrupted();
  }
  if (calls.strays() != 0) throw std::runtime_error("a function returned to no call of it");
  auto rows = timing::task_rows(program, analysis);
  timing::add_measured(rows, calls);
  return {.rows = std::move(rows), .sum = sum};
}

}  // namespace command
