// SPDX-License-Identifier: Apache-2.0
// Interrupts in the middle of everything: the processor's model is taken back all the time, and the
// netlist does the same. The program is the benchmark's, which fits into the chip's memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "directories.hpp"
#include "sim/devices/serial_line.hpp"
#include "sim/replay/interval_recorder.hpp"
#include "sim/replay/netlist_replay.hpp"
#include "sim/simulation/simulation.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/benchmark/stepping_run.hpp"

namespace {

constexpr std::uint32_t clock_hz = 16'000'000;
constexpr sim::Clock length = 100'000, clocks = 3'000'000;
constexpr std::uint64_t step_pins = (1U << sim::axis_count) - 1;

// The processor sends back each byte that comes meanwhile.
constexpr benchmarks::Motion motion{
    .interval_clocks = 400.3, .ticks_per_line = 100, .lines = 60, .axes = 4, .baud = 1'000'000};

std::vector<replay::Interval> recorded_steps() {
  std::vector<replay::Interval> intervals;
  replay::IntervalRecorder recorder(
      length, [&](replay::Interval&& interval) { intervals.push_back(std::move(interval)); });
  sim::VerilatedChip chip(clock_hz);
  benchmarks::load_motion(
      sim::read_elf(BUILD_DIRECTORY "/firmware/stepping_benchmark_software.elf"), motion, chip);
  chip.record(recorder);
  const sim::ClockRate rate(clock_hz);
  sim::Simulation simulation(chip, rate);
  devices::SerialLine line(rate, motion.baud, chip.inputs());
  simulation.attach(line, sim::OutputPins::transmit_pin());
  line.send(0, std::string(clocks / rate.clocks(10.0 / motion.baud), 'U'));
  simulation.run_until(clocks);
  recorder.finish(chip.now());
  return intervals;
}

int rises_of_steps(const replay::Interval& interval) {
  int rises = 0;
  std::uint64_t before = 0;
  for (const replay::OutputChange& change : interval.outputs) {
    const std::uint64_t steps = change.pins.word & step_pins;
    rises += std::popcount(steps & ~before);
    before = steps;
  }
  return rises;
}

TEST(SoftwareStepping, is_the_same_by_the_processor_s_model_and_by_its_netlist) {
  const replay::Replay replay = replay::make_netlist_replay(clock_hz, true, sim::Edges::leaping);
  const std::vector<replay::Interval> intervals = recorded_steps();
  EXPECT_GT(intervals.size(), 10U);
  int rises = 0;
  for (const replay::Interval& interval : intervals) {
    rises += rises_of_steps(interval);
    const auto difference = replay(interval);
    EXPECT_FALSE(difference) << difference->what << " in clock " << difference->clock;
  }
  // Of all axes: 100, 83, 61 and 37 in a line.
  EXPECT_EQ(rises, 60 * (100 + 83 + 61 + 37));
}

}  // namespace
