// SPDX-License-Identifier: Apache-2.0
// A plan, and the same print by the whole chip with its firmware: the same steps in the same time.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/devices/file_host.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tests/loaded_printer.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

constexpr std::uint32_t clock_hz = 50'000'000;
constexpr double hotend_c = 205;

class EdgeTimes : public devices::StepListener {
 public:
  void stepped(const devices::StepEdge& edge) override {
    if (first == 0) first = edge.clock;
    last = edge.clock;
    ++(edge.direction > 0 ? forward : backward)[edge.axis];
  }

  sim::Clock first = 0, last = 0;
  std::array<std::uint64_t, axis_count> forward{}, backward{};
};

// Perimeters, zigzags, retractions, arcs, a layer change and a pause.
std::string job() {
  std::string text = "G1 Z0.2 F600\nG92 E0\n";
  for (int i = 0; i <= 60; ++i) {
    text += "G1 X" + std::to_string(20 + 15 * std::sin(i * 0.1047)) + " Y" +
            std::to_string(20 + 15 * std::cos(i * 0.1047)) + " E" + std::to_string(i * 0.06) +
            " F2400\n";
  }
  text += "G1 E2.6 F1800\nG1 Z0.4 F600\nG1 X10 Y10 F7200\nG1 E3.6 F1800\nG4 P300\n";
  for (int i = 0; i < 40; ++i) {
    text += "G1 X" + std::to_string(i % 2 == 0 ? 30 : 10) + " Y" + std::to_string(10 + i * 0.45) +
            " E" + std::to_string(3.6 + i * 0.1) + " F4800\n";
  }
  return text + "G2 X30 Y10 R20 F3000\nG1 X0 Y0 F9000\n";
}

TEST(plan_agreement, a_print_takes_the_planned_time_to_half_a_percent) {
  const auto commands = devices::parse_gcode_text(job(), "job").value();
  PrintPlanner planner(clock_hz);
  for (const auto& command : commands) planner.take(command.file_line, command.text);
  const Plan plan = planner.finish();
  ASSERT_TRUE(plan.refused.empty()) << plan.refused[0].text << plan.refused[0].reason;

  sim::VerilatedChip chip(clock_hz);
  tests::LoadedPrinter loaded(chip, clock_hz, hotend_c, 22);
  EdgeTimes edges;
  loaded.printer.add_step_listener(edges);
  devices::FileHost host(devices::parse_gcode_text("M109 S205\n" + job(), "job").value(),
                         loaded.printer.serial_line(), loaded.simulation.rate());
  loaded.simulation.attach(host, {});
  while (!host.ended()) loaded.simulation.run_until(loaded.simulation.now() + clock_hz / 10);
  loaded.simulation.run_until(loaded.simulation.now() + 2 * clock_hz);

  const double printed = static_cast<double>(edges.last - edges.first) / clock_hz;
  const double planned = plan.seconds - plan.first_move_seconds;
  std::printf("planned %.3f s, printed %.3f s\n", planned, printed);
  EXPECT_NEAR(planned / printed, 1.0, 0.005);
  for (std::size_t i = 0; i < axis_count; ++i) {
    EXPECT_EQ(plan.axes[i].steps_forward, edges.forward[i]) << i;
    EXPECT_EQ(plan.axes[i].steps_backward, edges.backward[i]) << i;
  }
}

}  // namespace
}  // namespace planning
