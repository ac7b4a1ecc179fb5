// SPDX-License-Identifier: Apache-2.0
// A motor at 10 kHz while a host asks for all that it can: each pulse comes in its clock.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "firmware/units/task_span.hpp"
#include "sim/devices/file_host.hpp"
#include "sim/report/firmware_watch.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tests/loaded_printer.hpp"

namespace {

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr sim::Clock clocks_of_a_pulse = clock_hz / 10'000;

struct Recorder : devices::StepListener {
  void stepped(const devices::StepEdge& edge) override {
    if (edge.axis == 0) clocks.push_back(edge.clock);
  }
  std::vector<sim::Clock> clocks;
};

// 125 mm/s are 10 kHz. The host has so many lines in flight, and more to ask than the move lasts.
void run_in_a_storm(std::size_t lines_in_flight) {
  std::string gcode = "G92 X0\nG1 X180 F7500\n";
  for (int i = 0; i < 60; ++i) gcode += "M503\nM119\nM115\nM105\n";
  const sim::ElfImage firmware = sim::read_elf(tests::firmware_file);
  sim::VerilatedChip chip(clock_hz);
  tests::LoadedPrinter loaded(chip, clock_hz, 200, 60);
  sim::Simulation& simulation = loaded.simulation;
  Recorder recorder;
  loaded.printer.add_step_listener(recorder);
  devices::FileHost host(devices::parse_gcode_text(gcode, "storm").value(),
                         loaded.printer.serial_line(), simulation.rate(),
                         {.window = lines_in_flight});
  simulation.attach(host, {});
  const std::size_t steps = 180 * 80;
  std::uint64_t bytes_at_end = 0;
  sim::Clock began = 0, ended = 0;
  while (simulation.now() < 20 * clock_hz && recorder.clocks.size() < steps) {
    simulation.run_until(simulation.now() + clock_hz / 1'000);
    if (began == 0 && !recorder.clocks.empty()) began = simulation.now();
    bytes_at_end = loaded.printer.serial_line().bytes_received();
    ended = simulation.now();
  }
  ASSERT_EQ(recorder.clocks.size(), steps);
  EXPECT_FALSE(host.ended()) << "the storm was over before the move";

  // Between the ramps, which take 5.3 mm each at 1500 mm/s^2.
  const std::size_t first = 6 * 80, last = steps - 6 * 80;
  for (std::size_t i = first + 1; i < last; ++i) {
    ASSERT_EQ(recorder.clocks[i] - recorder.clocks[i - 1], clocks_of_a_pulse) << i;
  }
  EXPECT_EQ(chip.queue_statistics().underruns, 0U);
  // The line to the host is nearly always busy.
  const double share = 10.0 * static_cast<double>(bytes_at_end) * clock_hz /
                       loaded.description.baud / static_cast<double>(ended - began);
  fmt::print("{} lines in flight: {:.0f} % of the line to the host\n", lines_in_flight,
             100 * share);
  EXPECT_GT(share, 0.3);
  const report::FirmwareWatch watch(firmware, chip);
  for (const report::TaskResult& task : watch.tasks()) {
    EXPECT_EQ(task.overruns, 0U) << task.name << ": " << task.longest_clocks;
  }
}

TEST(Storm, does_not_move_a_pulse_of_10_kHz) {
  for (const std::size_t lines_in_flight : {1U, 4U, 8U}) run_in_a_storm(lines_in_flight);
}

}  // namespace
