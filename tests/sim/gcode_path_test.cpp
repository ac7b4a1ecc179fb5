// SPDX-License-Identifier: Apache-2.0
// The report's own reader of G-code.
#include "sim/report/gcode_path.hpp"

#include <gmock/gmock.h>

namespace {

using report::GcodePath;
using testing::ElementsAre;

report::Point end_of(GcodePath& path, std::string_view command) {
  const report::Request request = path.read(command);
  EXPECT_TRUE(std::holds_alternative<report::Move>(request)) << command;
  return path.position();
}

TEST(GcodePath, reads_numbers_as_slicers_and_people_write_them) {
  GcodePath path;
  EXPECT_THAT(end_of(path, "G1 X10. Y-.5 Z+.2"), ElementsAre(10.0, -0.5, 0.2, 0.0));
  EXPECT_THAT(end_of(path, "g01x1y2"), ElementsAre(1.0, 2.0, 0.2, 0.0));
  EXPECT_THAT(end_of(path, "G0 X 3"), ElementsAre(3.0, 2.0, 0.2, 0.0));
}

TEST(GcodePath, sees_no_motion_in_a_feed_rate) {
  GcodePath path;
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("G1 F1200")));
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("M117 G1 X5")));
}

TEST(GcodePath, keeps_the_extruder_mode_apart) {
  GcodePath path;
  path.read("M83");
  end_of(path, "G1 X1 E2");
  EXPECT_THAT(end_of(path, "G1 X2 E2"), ElementsAre(2.0, 0.0, 0.0, 4.0));
  path.read("M82");
  path.read("G92 E0");
  EXPECT_THAT(end_of(path, "G1 E1"), ElementsAre(2.0, 0.0, 0.0, 5.0));
}

TEST(GcodePath, homes_named_axes_only) {
  GcodePath path;
  end_of(path, "G1 X5 Y6 Z7");
  const report::Request request = path.read("G28 X0 Y0");
  EXPECT_THAT(std::get<report::Homing>(request).axes, ElementsAre(true, true, false));
  EXPECT_THAT(path.position(), ElementsAre(0.0, 0.0, 7.0, 0.0));
}

TEST(GcodePath, reads_targets_of_both_heaters) {
  GcodePath path;
  const auto hotend = std::get<report::TemperatureTarget>(path.read("M109 S205"));
  EXPECT_EQ(hotend.celsius, 205);
  EXPECT_TRUE(hotend.waits);
  EXPECT_FALSE(hotend.bed);
  EXPECT_TRUE(std::get<report::TemperatureTarget>(path.read("M140 S60")).bed);
}

}  // namespace
