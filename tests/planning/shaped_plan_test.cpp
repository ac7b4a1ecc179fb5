// SPDX-License-Identifier: Apache-2.0
// Whole files with input shaping and linear advance: the same totals, and only a little more time.
#include <gmock/gmock.h>

#include <cstdio>
#include <string>
#include <vector>

#include "directories.hpp"
#include "machine_generator/description.hpp"
#include "sim/devices/gcode_file.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

constexpr std::uint32_t clock_hz = 50'000'000;

Plan plan_with(const std::string& file, const std::vector<std::string>& settings) {
  auto machine =
      machine_generator::read_machine(PROJECT_DIRECTORY "/firmware/machines/bed_slinger.toml");
  machine.description.name = machine.name;
  machine.description.shaping.emplace();
  PrintPlanner planner(machine.description, clock_hz);
  for (const std::string& line : settings) planner.take(1, line);
  const auto commands = devices::read_gcode_file(PROJECT_DIRECTORY "/examples/" + file).value();
  for (const auto& command : commands) {
    // Its own settings would replace those.
    if (command.text.starts_with("M900") || command.text.starts_with("M593")) continue;
    planner.take(command.file_line, command.text);
  }
  return planner.finish();
}

class ShapedPlan : public testing::TestWithParam<const char*> {};

TEST_P(ShapedPlan, has_the_totals_of_the_unshaped_one) {
  const Plan plain = plan_with(GetParam(), {});
  const Plan shaped =
      plan_with(GetParam(), {"M593 X P\"mzv\" F45 D0.1", "M593 Y P\"ei\" F32 D0.1", "M900 K0.05"});
  EXPECT_THAT(shaped.refused, testing::SizeIs(plain.refused.size()));
  EXPECT_EQ(shaped.underruns, 0u);
  for (std::size_t i = 0; i < axis_count; ++i) {
    EXPECT_EQ(shaped.axes[i].steps_forward - shaped.axes[i].steps_backward,
              plain.axes[i].steps_forward - plain.axes[i].steps_backward)
        << i;
  }
  EXPECT_NEAR(shaped.filament_mm, plain.filament_mm, 1e-6);
  std::printf("%s: %.2f s, shaped %.2f s\n", GetParam(), plain.seconds, shaped.seconds);
  EXPECT_GT(shaped.seconds, plain.seconds);
  EXPECT_LT(shaped.seconds, 1.1 * plain.seconds);
  // E gives way in corners, and X and Y do not.
  EXPECT_GT(shaped.axes[3].steps_backward, plain.axes[3].steps_backward);
}

INSTANTIATE_TEST_SUITE_P(examples, ShapedPlan,
                         testing::Values("washer.gcode", "cube20_02_marlin.gcode"));

}  // namespace
}  // namespace planning
