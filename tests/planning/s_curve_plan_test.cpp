// SPDX-License-Identifier: Apache-2.0
// Plans with ramps of third order: the times and peaks of lines that are easily calculated, and a
// whole file.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "directories.hpp"
#include "machine/machine.hpp"
#include "sim/devices/gcode_file.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

using testing::DoubleNear;

constexpr std::uint32_t clock_hz = 50'000'000;

application::MachineDescription machine_with(bool s_curve) {
  application::MachineDescription machine = machine::machine;
  machine.limits.s_curve = s_curve;
  return machine;
}

Plan plan_of(bool s_curve, std::initializer_list<std::string_view> lines) {
  const application::MachineDescription machine = machine_with(s_curve);
  PrintPlanner planner(machine, clock_hz);
  std::size_t number = 0;
  for (const std::string_view line : lines) planner.take(++number, line);
  return planner.finish();
}

// From rest, the speed is that in the middle of the first step by the mean acceleration.
TEST(s_curve_plan, of_a_long_line_has_ramps_of_twice_the_time_and_the_same_peaks) {
  constexpr double peak = 1000, speed = 100, length = 100, step_mm = 1 / 80.0;
  const Plan plan = plan_of(true, {"M205 X0.1 Y0.1 Z0.1 E0.1", "M204 T1000", "G1 X100 F6000"});
  const double change = speed - std::sqrt(peak / 2 * step_mm);
  const double seconds = length / speed + change * change / (speed * peak / 2);
  EXPECT_THAT(plan.moving_seconds, DoubleNear(seconds, 0.001));
  EXPECT_THAT(plan.axes[0].max_speed_mm_per_s, DoubleNear(speed, 0.1));
  EXPECT_LE(plan.axes[0].max_acceleration_mm_per_s2, peak * 1.0001);
  EXPECT_THAT(plan.axes[0].max_acceleration_mm_per_s2, DoubleNear(peak, 5));
  EXPECT_EQ(plan.axes[0].steps_forward, 8000u);
  EXPECT_EQ(plan.moves, 1u);
}

// At half the speed all times double, and accelerations are a quarter.
TEST(s_curve_plan, stretches_with_the_speed_factor) {
  const Plan plan = plan_of(
      true, {"M205 X0.1 Y0.1 Z0.1 E0.1", "M204 T1000", "G1 X100 F6000", "M220 S50", "G1 X0 F6000"});
  EXPECT_LE(plan.axes[0].max_acceleration_mm_per_s2, 1000.1);
  EXPECT_EQ(plan.axes[0].steps_backward, 8000u);
}

TEST(s_curve_plan, of_a_file_has_the_same_totals_and_keeps_the_limits) {
  const auto commands =
      devices::read_gcode_file(PROJECT_DIRECTORY "/examples/washer.gcode").value();
  Plan plans[2];
  for (const bool s_curve : {false, true}) {
    const application::MachineDescription machine = machine_with(s_curve);
    PrintPlanner planner(machine, clock_hz);
    for (const auto& command : commands) planner.take(command.file_line, command.text);
    plans[s_curve ? 1 : 0] = planner.finish();
  }
  EXPECT_EQ(plans[1].underruns, 0u);
  EXPECT_EQ(plans[1].moves, plans[0].moves);
  for (std::size_t i = 0; i < axis_count; ++i) {
    EXPECT_EQ(plans[1].axes[i].steps_forward, plans[0].axes[i].steps_forward);
    EXPECT_EQ(plans[1].axes[i].steps_backward, plans[0].axes[i].steps_backward);
    // Short lines have a step more than their distance; those with such ramps are others.
    EXPECT_LE(plans[1].axes[i].max_acceleration_mm_per_s2,
              plans[0].axes[i].max_acceleration_mm_per_s2 * 1.03);
  }
  std::printf("washer: %.2f s moving, with ramps of third order %.2f s\n", plans[0].moving_seconds,
              plans[1].moving_seconds);
  EXPECT_GT(plans[1].moving_seconds, plans[0].moving_seconds);
  EXPECT_LT(plans[1].moving_seconds, 1.5 * plans[0].moving_seconds);
}

}  // namespace
}  // namespace planning
