// SPDX-License-Identifier: Apache-2.0
// G2 and G3 that are not drawn.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr std::size_t x = 0, y = 1;

TEST(arc_refusals, are_refused_where_they_are_no_arcs) {
  Printer printer;
  printer.talk("-> G28\n<- ok");
  printer.talk(R"(
    -> G1 X50 Y50 F6000
    <- ok
    -> M400
    <- ok
    -> G2 X60 Y60
    <- echo:Arc with neither R nor I, J or K, not executed: "G2 X60 Y60"
    <- ok
    -> G2 X60 I5 R5
    <- echo:Arc with both R and I, J or K, not executed: "G2 X60 I5 R5"
    <- ok
    -> G2 X60 Y60 I0 J0
    <- echo:arc without radius, not executed: "G2 X60 Y60 I0 J0"
    <- ok
    -> G3 R5
    <- echo:arc without radius, not executed: "G3 R5"
    <- ok
    -> G3 X61 I5
    <- echo:arc's end is not on its circle, not executed: "G3 X61 I5"
    <- ok
    -> G3 X61 R5
    <- echo:arc's ends are farther apart than 2 R, not executed: "G3 X61 R5"
    <- ok
    -> G3 X60 R10001
    <- echo:arc with a radius above 10 m, not executed: "G3 X60 R10001"
    <- ok
    -> G3 X60 I5 P2
    <- echo:Unknown parameter, not executed: "G3 X60 I5 P2"
    <- ok
    -> G3 X60 I
    <- echo:Number missing after I, not executed: "G3 X60 I"
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[y], 4000);
  EXPECT_EQ(printer.chip.position[x], 4000);
}

TEST(arc_refusals, are_refused_as_a_whole_where_they_leave_the_travel) {
  Printer printer;
  printer.talk("-> G28\n<- ok");
  printer.talk(R"(
    -> G1 X50 Y5 F6000
    <- ok
    -> G3 X70 Y5 I10 F1200
    <- echo:Move beyond the end of Y (0.00 to 200.00), not executed: "G3 X70 Y5 I10 F1200"
    <- ok
    -> G2 X70 Y5 I10
    <- ok
    -> G2 I-5 J0
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[x], 5600);
}

// Where the axes are not homed, only the planner refuses what is too long.
TEST(arc_refusals, leave_feedrate_and_position_as_they_were_where_no_chord_can_be_made) {
  Printer printer;
  printer.talk(R"(
    -> G1 X11 F60
    <- ok
    -> G2 Y0.5 R10 Z4294967 E5 F6000
    <* cold extrusion prevented
    <* not executed: "G2 Y0.5 R10 Z4294967 E5 F6000"
    <- ok
    -> M114
    <* X:11.00 Y:0.00 Z:0.00 E:0.00
    <- ok
    -> M400
    <- ok
  )");
  // A millimetre at 60 mm/min takes a second.
  const auto began = printer.chip.time;
  printer.talk("-> G1 X12\n<- ok\n-> M400\n<- ok");
  EXPECT_GT(printer.chip.time - began, clock_hz * 9 / 10);
}

}  // namespace
}  // namespace application_test
