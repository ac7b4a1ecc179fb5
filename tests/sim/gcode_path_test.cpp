// SPDX-License-Identifier: Apache-2.0
// The report's own reader of G-code.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/sim/gcode_ends.hpp"

namespace {

using report::GcodePath;
using testing::ElementsAre;
using tests::end_of;
using tests::place;

constexpr report::Femtometers mm = report::femtometers_per_mm;

TEST(GcodePath, reads_numbers_as_slicers_and_people_write_them) {
  GcodePath path;
  EXPECT_THAT(end_of(path, "G1 X10. Y-.5 Z+.2"), ElementsAre(10.0, -0.5, 0.2, 0.0));
  EXPECT_THAT(end_of(path, "g01x1y2"), ElementsAre(1.0, 2.0, 0.2, 0.0));
  EXPECT_THAT(end_of(path, "G0 X 3"), ElementsAre(3.0, 2.0, 0.2, 0.0));
}

TEST(GcodePath, reads_arcs_with_their_centre_or_radius) {
  GcodePath path;
  end_of(path, "G1 X10 Y10");
  const auto arc = [&](std::string_view line) {
    return *std::get<report::Move>(path.read(line)).arc;
  };
  const auto near = [](double first, double second) {
    return ElementsAre(testing::DoubleNear(first, 1e-9), testing::DoubleNear(second, 1e-9));
  };
  EXPECT_THAT(arc("G2 X20 I5").at(0.5), near(15, 15));
  EXPECT_THAT(arc("G3 X10 R5").at(0.5), near(15, 15));
  EXPECT_THAT(arc("G3 X15 Y15 R-5").at(0.5),
              near(15 + 5 * std::sqrt(0.5), 10 - 5 * std::sqrt(0.5)));
  EXPECT_NEAR(arc("G2 I-5").length_mm(), 10 * std::numbers::pi, 1e-9);
  EXPECT_THAT(arc("G2 I-5").at(0.25), near(10, 10));
  path.read("G18");
  EXPECT_THAT(arc("G2 X25 I5").at(0.5), near(-5, 20));  // Z and X
  EXPECT_THAT(place(path), ElementsAre(25.0, 15.0, 0.0, 0.0));
}

TEST(GcodePath, retracts_and_recovers_what_m207_and_m208_say) {
  GcodePath path;
  path.read("G1 X1 Z2 E10");
  EXPECT_EQ(end_of(path, "G10"), (std::array<double, 4>{1, 0, 2, 7}));
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("G10")));
  EXPECT_EQ(end_of(path, "G1 X5 E11"), (std::array<double, 4>{5, 0, 2, 8}));
  path.read("M207 S1 Z0.5");
  path.read("M208 S0.25");
  EXPECT_EQ(end_of(path, "G11"), (std::array<double, 4>{5, 0, 2, 11.25}));
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("G11")));
  EXPECT_EQ(end_of(path, "G10"), (std::array<double, 4>{5, 0, 2.5, 10.25}));
  path.read("G92 Z0");
  EXPECT_EQ(end_of(path, "G11"), (std::array<double, 4>{5, 0, 2, 11.5}));
}

TEST(GcodePath, does_not_lower_z_after_a_stop_or_homing) {
  GcodePath path;
  path.read("G1 Z2 E10");
  path.read("M207 S1 Z0.5");
  path.read("G10");
  path.read("M410");
  EXPECT_EQ(end_of(path, "G11"), (std::array<double, 4>{0, 0, 2.5, 10}));
  EXPECT_EQ(end_of(path, "G1 Z2"), (std::array<double, 4>{0, 0, 2, 10}));
  path.read("G10");
  path.read("G28 Z");
  EXPECT_EQ(end_of(path, "G11"), (std::array<double, 4>{0, 0, 0, 10}));
  EXPECT_EQ(end_of(path, "G1 Z2"), (std::array<double, 4>{0, 0, 2, 10}));
}

// The chip makes two lines of each, so that Z never goes along with the filament.
TEST(GcodePath, lifts_behind_the_retraction_and_lowers_before_the_filament_comes_back) {
  GcodePath path({.retraction = {.length = 2 * mm, .lift = mm, .extra = {}}, .travel = {}});
  const auto over = [&](const char* command) {
    const auto move = std::get<report::Move>(path.read(command));
    return std::array{move.over.value()[2], move.over.value()[3]};
  };
  EXPECT_EQ(over("G10"), (std::array{0 * mm, -2 * mm}));
  path.read("G1 X5");
  EXPECT_EQ(over("G11"), (std::array{0 * mm, -2 * mm}));
  path.read("M207 Z0");
  EXPECT_FALSE(std::get<report::Move>(path.read("G10")).over);
}

TEST(GcodePath, begins_with_the_retraction_of_the_machine) {
  GcodePath path({.retraction = {.length = 2 * mm, .lift = mm, .extra = {}}, .travel = {}});
  EXPECT_EQ(end_of(path, "G10"), (std::array<double, 4>{0, 0, 1, -2}));
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
  EXPECT_THAT(place(path), ElementsAre(0.0, 0.0, 7.0, 0.0));
}

TEST(GcodePath, adds_without_any_error) {
  GcodePath path;
  path.read("G91");
  for (int i = 0; i < 1'000'000; ++i) path.read("G1 X0.000001 Y-0.1 E0.00007");
  EXPECT_THAT(path.position(), ElementsAre(1 * mm, -100'000 * mm, 0, 70 * mm, 0));
  path.read("G20");
  path.read("M221 S33");
  path.read("G1 X0.000000001 E0.000000003");
  EXPECT_THAT(path.position(),
              ElementsAre(1 * mm + 25'400, -100'000 * mm, 0, 70 * mm + 3 * 254 * 33, 0));
}

TEST(GcodePath, rounds_the_tenth_decimal_away_from_zero) {
  GcodePath path;
  path.read("G1 X0.0000000005 Y-0.0000000005 Z0.00000000049");
  EXPECT_THAT(path.position(), ElementsAre(mm / 1'000'000'000, -mm / 1'000'000'000, 0, 0, 0));
}

TEST(GcodePath, moves_no_axis_by_a_second_command_or_a_subcode) {
  GcodePath path;
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("G1.1 X5")));
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("G17 G1 X5")));
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("M862.3 P \"G1 X5\"")));
  EXPECT_THAT(place(path), ElementsAre(0, 0, 0, 0));
}

TEST(GcodePath, reads_targets_of_both_heaters) {
  GcodePath path;
  const auto hotend = std::get<report::TemperatureTarget>(path.read("M109 S205"));
  EXPECT_EQ(hotend.celsius, 205);
  EXPECT_TRUE(hotend.waits);
  EXPECT_FALSE(hotend.bed);
  EXPECT_TRUE(std::get<report::TemperatureTarget>(path.read("M140 S60")).bed);
}

TEST(GcodePath, reads_targets_in_the_unit_of_m149) {
  GcodePath path;
  const auto target = [&](std::string_view line) {
    return std::get<report::TemperatureTarget>(path.read(line)).celsius;
  };
  path.read("M149 F");
  EXPECT_DOUBLE_EQ(target("M104 S401"), 205);
  EXPECT_EQ(target("M104 S0"), 0);
  path.read("M149 K");
  path.read("M149");
  EXPECT_NEAR(target("M109 R478.15"), 205, 1e-9);
  EXPECT_EQ(target("M140 S0"), 0);
  path.read("M149 C");
  EXPECT_EQ(target("M109 S205"), 205);
}

// After Marlin's pages of G53 to G59.3, G92, M206.
TEST(GcodePath, knows_the_systems_of_coordinates) {
  GcodePath path;
  for (const char* line : {"G28", "G1 X10 Y10", "G55", "G92 X0 Y1", "G59.2", "G92 X5"}) {
    path.read(line);
  }
  EXPECT_THAT(end_of(path, "G1 X6 Y10"), ElementsAre(11, 10, 0, 0));
  path.read("G55");
  EXPECT_THAT(end_of(path, "G1 X2 Y2"), ElementsAre(12, 11, 0, 0));
  EXPECT_THAT(end_of(path, "G53 G1 X20"), ElementsAre(20, 11, 0, 0));
  EXPECT_THAT(end_of(path, "G1 Y3"), ElementsAre(20, 12, 0, 0));
  path.read("G54");
  EXPECT_THAT(end_of(path, "G1 X2"), ElementsAre(2, 12, 0, 0));
  for (const char* line : {"G55", "G92.1"}) path.read(line);
  EXPECT_THAT(end_of(path, "G1 X3"), ElementsAre(3, 12, 0, 0));
  for (const char* line : {"M206 X1", "G28 Y"}) path.read(line);
  EXPECT_THAT(end_of(path, "G1 X9 Y4"), ElementsAre(8, 4, 0, 0));
}

TEST(GcodePath, leads_to_places_of_the_machine) {
  GcodePath path({.retraction = {}, .travel = {200 * mm, 190 * mm, 100 * mm}});
  for (const char* line : {"G28", "G1 X30 Y40 Z5 E3", "G60 S1"}) path.read(line);
  EXPECT_THAT(end_of(path, "G27"), ElementsAre(10, 180, 20, 3));
  EXPECT_THAT(end_of(path, "G27 P2"), ElementsAre(10, 180, 40, 3));
  EXPECT_THAT(end_of(path, "G61 S1 X Z1"), ElementsAre(30, 180, 6, 3));
  EXPECT_THAT(end_of(path, "G61 S1"), ElementsAre(30, 40, 5, 3));
  EXPECT_THAT(end_of(path, "G1 X31 E4"), ElementsAre(31, 40, 5, 4));
  for (const char* line : {"G1 X15 Y6", "M428"}) path.read(line);
  EXPECT_THAT(end_of(path, "G1 X2 Y2 Z1"), ElementsAre(17, 8, 6, 4));
  path.read("M290 Z0.25");
  EXPECT_THAT(end_of(path, "G1 Z2"), ElementsAre(17, 8, 7, 4));
  EXPECT_THAT(end_of(path, "G1 X3"), ElementsAre(18, 8, 7.25, 4));
}

TEST(GcodePath, measures_filament_by_its_volume) {
  GcodePath path;
  for (const char* line : {"G28", "M200 D2"}) path.read(line);
  EXPECT_NEAR(end_of(path, "G1 E31.41592654")[3], 10, 1e-8);
  for (const char* line : {"M200 D0", "G92 E0"}) path.read(line);
  EXPECT_NEAR(end_of(path, "G1 E1")[3], 11, 1e-8);
}

}  // namespace
