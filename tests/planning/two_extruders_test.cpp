// SPDX-License-Identifier: Apache-2.0
// A plan for a machine with two extruders.
#include <gmock/gmock.h>

#include <string>

#include "directories.hpp"
#include "machine_generator/description.hpp"
#include "sim/devices/gcode_file.hpp"
#include "tools/planning/plan_texts.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

using testing::HasSubstr;

Plan plan_of(const std::string& machine, const std::string& gcode) {
  auto read =
      machine_generator::read_machine(PROJECT_DIRECTORY "/firmware/machines/" + machine + ".toml");
  read.description.name = read.name;
  PrintPlanner planner(read.description, 50'000'000);
  const auto commands = devices::parse_gcode_text(gcode, "job").value();
  for (const auto& command : commands) planner.take(command.file_line, command.text);
  return planner.finish();
}

const std::string gcode =
    "G28\nM83\nG1 X60 Y60 Z0.2 F3000\nG1 X80 E5\nT1\nG1 X60 E2\nG1 E-0.5\nT0\nG1 X80 E1\n";

// Both swaps of 4 mm have come forward again but the last one of T1.
TEST(plan, counts_filament_and_steps_of_each_tool) {
  const Plan plan = plan_of("two_extruders", gcode);
  EXPECT_THAT(plan.refused, testing::IsEmpty());
  EXPECT_NEAR(plan.filament_of_tool_mm[0], 6, 0.01);
  EXPECT_NEAR(plan.filament_of_tool_mm[1], 1.5 - 4, 0.02);
  EXPECT_EQ(plan.axes[3].steps_forward - plan.axes[3].steps_backward, 573u);
  EXPECT_EQ(plan.axes[4].steps_forward, 191u);
  EXPECT_EQ(plan.axes[4].steps_backward, 430u);
  EXPECT_THAT(to_json(plan, {}), HasSubstr("\"e1\""));
  EXPECT_THAT(to_text(plan, {}), HasSubstr("6.0 of T0"));
}

TEST(plan, refuses_a_second_tool_that_is_not_there) {
  const Plan plan = plan_of("bed_slinger", gcode);
  ASSERT_EQ(plan.refused.size(), 1u);
  EXPECT_EQ(plan.refused[0].text, "T1");
  EXPECT_THAT(to_json(plan, {}), testing::Not(HasSubstr("e1")));
}

}  // namespace
}  // namespace planning
