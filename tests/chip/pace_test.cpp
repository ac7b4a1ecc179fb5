// SPDX-License-Identifier: Apache-2.0
// M220 in the middle of a print on the whole chip: the same pulses in the same order, only later.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "sim/devices/file_host.hpp"
#include "sim/machine/printer.hpp"
#include "sim/simulation/elf_image.hpp"
#include "sim/simulation/verilated_chip.hpp"

namespace {

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr sim::Clock second = clock_hz;

struct Recorder : devices::StepListener {
  void stepped(const devices::StepEdge& edge) override { edges.push_back(edge); }
  std::vector<devices::StepEdge> edges;
};

std::vector<devices::StepEdge> print(const std::string& gcode) {
  sim::VerilatedChip chip(clock_hz);
  sim::load(sim::read_elf(FIRMWARE), chip);
  sim::Simulation simulation(chip, sim::ClockRate(clock_hz));
  const auto description =
      machine::read_description(PROJECT_DIRECTORY "/firmware/machines/prusa_mendel.toml");
  machine::Printer printer(
      description,
      {.baud = description.baud, .hotend_start_c = 25, .bed_start_c = 25, .faults = {}},
      simulation);
  Recorder recorder;
  printer.add_step_listener(recorder);
  devices::FileHost host(devices::parse_gcode_text(gcode, "test").value(), printer.serial_line(),
                         simulation.rate());
  simulation.attach(host, {});
  while (!host.ended() && simulation.now() < 20 * second) {
    simulation.run_until(simulation.now() + second / 10);
  }
  EXPECT_EQ(host.state(), devices::HostState::completed) << host.fault();
  EXPECT_EQ(chip.queue_statistics().underruns, 0u);
  return recorder.edges;
}

TEST(pace, m220_s50_in_mid_print_gives_the_same_pulses_in_the_same_order_only_later) {
  const std::string begin = "G91\nG1 X12 Y5 F3000\nG1 X-2 Y7.3\nG1 X5.1 Y-1\n";
  const std::string end = "G1 X-8 Y-3\nG1 X9 Y4 Z0.02\nG1 X-6 Y-2\nG1 X4.2 Y1.9 F2400\n";
  const auto usual = print(begin + end);
  const auto slowed = print(begin + "M220 S50\n" + end);
  ASSERT_GT(usual.size(), 3000u);
  ASSERT_EQ(usual.size(), slowed.size());
  sim::Clock delay = 0;
  for (std::size_t i = 0; i < usual.size(); ++i) {
    const auto what = [](const devices::StepEdge& edge) {
      return std::tuple(edge.axis, edge.direction, edge.position);
    };
    ASSERT_EQ(what(usual[i]), what(slowed[i])) << i;
    const sim::Clock now =
        (slowed[i].clock - slowed[0].clock) + 4 - (usual[i].clock - usual[0].clock);
    ASSERT_LT(now, 20 * second) << i << ": sooner";
    ASSERT_GE(now + 4, delay) << i << ": caught up";
    delay = std::max(delay, now);
  }
  // It comes while the first line is made, so nearly all is made at half the speed.
  const sim::Clock duration = usual.back().clock - usual[0].clock;
  EXPECT_GT(delay, duration * 7 / 10);
  EXPECT_LE(delay, duration + 4);
}

}  // namespace
