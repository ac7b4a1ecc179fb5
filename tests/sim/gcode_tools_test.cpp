// SPDX-License-Identifier: Apache-2.0
// The report's own reader of G-code: two extruders, and filament apart from the coordinates.
#include <gmock/gmock.h>

#include <array>
#include <vector>

#include "tests/sim/gcode_ends.hpp"

namespace {

using report::GcodePath;
using testing::ElementsAre;
using tests::end_of;

constexpr report::Femtometers mm = report::femtometers_per_mm;

// Where the carriage and both filaments are after each move of a change of tools.
std::vector<std::array<double, 5>> changes(GcodePath& path, std::string_view command) {
  std::vector<std::array<double, 5>> ends;
  const report::Request request = path.read(command);
  for (const report::Move& move : std::get<report::ToolMoves>(request).moves) {
    std::array<double, 5>& end = ends.emplace_back();
    for (std::size_t i = 0; i < end.size(); ++i) end[i] = report::millimeters(move.to[i]);
  }
  return ends;
}

const report::MachineFacts two_tools{
    .retraction = {},
    .travel = {200 * mm, 200 * mm, 100 * mm},
    .second_tool = report::ToolFacts{.offset = {20 * mm, 1 * mm, -mm / 4}, .lift = 2 * mm}};

TEST(GcodePath, leads_the_new_nozzle_to_the_place_of_the_old_one) {
  GcodePath path(two_tools);
  path.read("G28");
  path.read("G1 X100 Y50 Z10 E5");
  path.read("M217 S4 B0.5 E1");
  using Ends = std::vector<std::array<double, 5>>;
  // Nothing is drawn back yet from the filament that comes.
  EXPECT_EQ(changes(path, "T1"), (Ends{{100, 50, 10, 1, 0},
                                       {100, 50, 12.25, 1, 0},
                                       {100, 50, 12.25, 1, 1},
                                       {80, 49, 12.25, 1, 1},
                                       {80, 49, 10.25, 1, 1}}));
  EXPECT_THAT(end_of(path, "G1 X110 E7"), ElementsAre(90.0, 49.0, 10.25, 1.0));
  EXPECT_EQ(report::millimeters(path.position()[4]), 3);
  EXPECT_EQ(changes(path, "T0"), (Ends{{90, 49, 10.25, 1, -1},
                                       {90, 49, 12.25, 1, -1},
                                       {90, 49, 12.25, 5, -1},
                                       {90, 49, 12.25, 6, -1},
                                       {110, 50, 12.25, 6, -1},
                                       {110, 50, 10, 6, -1},
                                       {110, 50, 10, 6.5, -1}}));
}

TEST(GcodePath, leaves_the_nozzle_where_it_may_not_move) {
  GcodePath path(two_tools);
  EXPECT_THAT(changes(path, "T1"), testing::IsEmpty());  // not homed
  EXPECT_THAT(end_of(path, "G1 X25 Y1"), ElementsAre(5.0, 0.0, 0.0, 0.0));
  path.read("G28");
  EXPECT_THAT(end_of(path, "G1 X120 Y51 Z9.75"), ElementsAre(100.0, 50.0, 10.0, 0.0));
  EXPECT_THAT(changes(path, "T0 S1"), testing::IsEmpty());
  EXPECT_THAT(end_of(path, "G1 X101"), ElementsAre(101.0, 50.0, 10.0, 0.0));
  path.read("G1 X5");
  EXPECT_THAT(changes(path, "T1"), testing::IsEmpty());  // beyond the travel
  EXPECT_THAT(end_of(path, "G1 X26"), ElementsAre(6.0, 50.0, 10.0, 0.0));
}

TEST(GcodePath, pushes_filament_forward_where_the_nozzle_stays) {
  GcodePath path(two_tools);
  path.read("G28");
  path.read("G1 X100 Y50 Z10 E5");
  path.read("M217 S4 Z0");
  path.read("T1");
  using Ends = std::vector<std::array<double, 5>>;
  EXPECT_EQ(changes(path, "T0 S1"), (Ends{{80, 49, 10.25, 5, 0}}));
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("T0")));
}

TEST(GcodePath, moves_filament_apart_from_the_coordinates) {
  report::MachineFacts facts;
  facts.filament = report::FilamentFacts{.load = 30 * mm, .unload = 20 * mm, .purge = 5 * mm};
  GcodePath path(facts);
  path.read("G1 X1 Z2 E10");
  using Ends = std::vector<std::array<double, 5>>;
  EXPECT_EQ(changes(path, "M701 Z3"),
            (Ends{{1, 0, 5, 10, 0}, {1, 0, 5, 40, 0}, {1, 0, 5, 45, 0}, {1, 0, 2, 45, 0}}));
  path.read("M603 U8");
  EXPECT_EQ(changes(path, "M702"), (Ends{{1, 0, 2, 37, 0}}));
  EXPECT_THAT(end_of(path, "G1 E11"), ElementsAre(1.0, 0.0, 2.0, 38.0));
}

TEST(GcodePath, gives_each_tool_its_flow_filament_retraction_and_heat) {
  GcodePath path(two_tools);
  path.read("M83");
  path.read("M221 S50 T1");
  path.read("G10");
  path.read("T1");
  path.read("G1 E2");
  EXPECT_EQ(report::millimeters(path.position()[3]), -3);
  EXPECT_EQ(report::millimeters(path.position()[4]), 1);
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(path.read("G11")));
  EXPECT_EQ(std::get<report::TemperatureTarget>(path.read("M104 S200")).tool, 1u);
  EXPECT_EQ(std::get<report::TemperatureTarget>(path.read("M104 S200 T0")).tool, 0u);
  GcodePath one;
  EXPECT_TRUE(std::holds_alternative<report::NoMotion>(one.read("T1")));
  EXPECT_EQ(std::get<report::TemperatureTarget>(one.read("M104 S200")).tool, 0u);
}

}  // namespace
