// SPDX-License-Identifier: Apache-2.0
// What a SCARA refuses, it refuses before anything moves.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "directories.hpp"
#include "machine_generator/description.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

Plan plan_of(const std::vector<std::string>& lines) {
  constexpr std::uint32_t clock_hz = 50'000'000;
  auto machine = machine_generator::read_machine(PROJECT_DIRECTORY "/firmware/machines/scara.toml");
  machine.description.name = machine.name;
  PrintPlanner planner(machine.description, clock_hz);
  std::size_t number = 0;
  for (const std::string& line : lines) planner.take(++number, line);
  return planner.finish();
}

void expect_refused(const std::string& line, const std::string& reason) {
  const std::string first = "G1 X20 Y1 F3000", last = "G1 X150 Y150";
  const Plan plan = plan_of({"G28", first, line, last});
  ASSERT_THAT(plan.refused, testing::SizeIs(1)) << line;
  EXPECT_EQ(plan.refused[0].text, line);
  EXPECT_THAT(plan.refused[0].reason, testing::HasSubstr(reason)) << line;
  const Plan without = plan_of({"G28", first, last});
  EXPECT_THAT(without.refused, testing::IsEmpty());
  EXPECT_EQ(plan.moves, without.moves);
  for (std::size_t i = 0; i < axis_count; ++i) {
    EXPECT_EQ(plan.axes[i].steps_forward, without.axes[i].steps_forward);
    EXPECT_EQ(plan.axes[i].steps_backward, without.axes[i].steps_backward);
  }
}

// The shoulder is at X100 Y-120, and the tool keeps 130 to 320 mm from it.
TEST(scara_plan, refuses_a_line_whose_middle_is_too_near_the_shoulder) {
  expect_refused("G1 X180 Y1", "target out of reach");
}

TEST(scara_plan, refuses_targets_too_near_too_far_and_off_the_bed) {
  expect_refused("G1 X100 Y5", "target out of reach");
  expect_refused("G1 X1 Y199", "target out of reach");
  expect_refused("G1 X201 Y100", "X");
  expect_refused("G1 Z151", "Z");
}

TEST(scara_plan, refuses_lines_before_homing_and_what_is_off_the_bed_without_soft_limits) {
  const Plan plan = plan_of({"G1 X100 Y100", "G28", "M211 S0", "G1 X200.2 Y100", "G1 X199 Y100"});
  ASSERT_THAT(plan.refused, testing::SizeIs(2));
  EXPECT_EQ(plan.refused[0].text, "G1 X100 Y100");
  EXPECT_EQ(plan.refused[1].text, "G1 X200.2 Y100");
}

// Each arm's speed and the acceleration of its ramps, along lines in all directions.
TEST(scara_plan, keeps_the_limits_of_each_arm) {
  const Plan plan =
      plan_of({"G28", "M204 T10000", "G1 X20 Y20 F12000", "G1 X180 Y20", "G1 X20 Y150",
               "G1 X199 Y100", "G1 X20 Y100", "G1 X20 Y20", "G1 X100 Y190"});
  EXPECT_THAT(plan.refused, testing::IsEmpty());
  EXPECT_EQ(plan.underruns, 0u);
  for (const std::size_t arm : {0UZ, 1UZ}) {
    EXPECT_LE(plan.axes[arm].max_speed_mm_per_s, 150 * 1.001);
    EXPECT_GT(plan.axes[arm].max_speed_mm_per_s, 20);
    EXPECT_LE(plan.axes[arm].max_acceleration_mm_per_s2, 1500 * 1.01);
    EXPECT_GT(plan.axes[arm].max_acceleration_mm_per_s2, 300);
  }
}

}  // namespace
}  // namespace planning
