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

constexpr int millimetres = 180, steps_of_a_millimetre = 80;
constexpr std::size_t steps = millimetres * steps_of_a_millimetre;
const std::string queries = "M503\nM119\nM115\nM105\n";

// 125 mm/s are 10 kHz. The hardware's queue holds half of these lines at most.
std::string lines(int millimetres_of_each) {
  std::string gcode;
  for (int x = millimetres_of_each; x <= millimetres; x += millimetres_of_each) {
    gcode += fmt::format("G1 X{} F7500\n", x);
  }
  return gcode;
}

// More to ask than the move lasts.
std::string storm() {
  std::string gcode;
  for (int i = 0; i < 60; ++i) gcode += queries;
  return gcode;
}

// At these speeds the chip's answers need half of the line, and more than all of it.
constexpr std::uint32_t half_used = 250'000, saturated = 115'200;

// The host has so many lines in flight. Returns the share of the line to the host that is used.
double run(const std::string& gcode, std::size_t lines_in_flight, std::uint32_t baud) {
  const sim::ElfImage firmware = sim::read_elf(tests::firmware_file);
  sim::VerilatedChip chip(clock_hz);
  tests::LoadedPrinter loaded(chip, clock_hz, 200, 60);
  sim::Simulation& simulation = loaded.simulation;
  chip.write_memory(firmware.symbol("serial_baud").value(), baud);
  loaded.printer.serial_line().set_baud(simulation.now(), baud);
  Recorder recorder;
  loaded.printer.add_step_listener(recorder);
  devices::FileHost host(devices::parse_gcode_text("G92 X0\n" + gcode, "storm").value(),
                         loaded.printer.serial_line(), simulation.rate(),
                         {.window = lines_in_flight});
  simulation.attach(host, {});
  const auto bytes = [&] { return loaded.printer.serial_line().bytes_received(); };
  std::uint64_t bytes_before = 0;
  sim::Clock began = 0;
  while (simulation.now() < 20 * clock_hz && recorder.clocks.size() < steps) {
    simulation.run_until(simulation.now() + clock_hz / 1'000);
    if (began != 0 || recorder.clocks.empty()) continue;
    began = simulation.now();
    bytes_before = bytes();
  }
  EXPECT_EQ(recorder.clocks.size(), steps);
  EXPECT_FALSE(host.ended()) << "the storm was over before the move";
  EXPECT_EQ(chip.queue_statistics().underruns, 0U);

  // Between the ramps, which take 5.3 mm each at 1500 mm/s^2.
  constexpr std::size_t ramp = 6 * steps_of_a_millimetre;
  std::size_t differ = 0;
  for (std::size_t i = ramp + 1; i + ramp < recorder.clocks.size(); ++i) {
    differ += recorder.clocks[i] - recorder.clocks[i - 1] != clocks_of_a_pulse;
  }
  EXPECT_EQ(differ, 0U) << "intervals are not of 10 kHz";
  const report::FirmwareWatch watch(firmware, chip);
  for (const report::TaskResult& task : watch.tasks()) {
    EXPECT_EQ(task.overruns, 0U) << task.name << ": " << task.longest_clocks;
  }
  const double share = 10.0 * static_cast<double>(bytes() - bytes_before) * clock_hz / baud /
                       static_cast<double>(simulation.now() - began);
  fmt::print("{} lines in flight, {} baud: {:.0f} % of the line to the host\n", lines_in_flight,
             baud, 100 * share);
  return share;
}

TEST(Storm, does_not_move_a_pulse_of_one_line_at_10_kHz) {
  for (const std::size_t lines_in_flight : {1U, 4U, 8U}) {
    EXPECT_GT(run(lines(millimetres) + storm(), lines_in_flight, half_used), 0.4);
  }
  EXPECT_GT(run(lines(millimetres) + storm(), 8, saturated), 0.95);
}

// Lines are handed over all the time: a refill that is late would show. Their own answers come
// first, and are short.
TEST(Storm, does_not_move_a_pulse_of_many_lines_at_10_kHz) {
  EXPECT_GT(run(lines(3) + storm(), 8, half_used), 0.4);
  EXPECT_GT(run(lines(3) + storm(), 8, saturated), 0.85);
}

}  // namespace
