// SPDX-License-Identifier: Apache-2.0
// G2 and G3 as dialogues and as what the axes then have done.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr std::size_t x = 0, y = 1, z = 2, e = 3;

void prepare(Printer& printer) {
  printer.chip.heaters[0].celsius = 200;
  printer.talk("-> G28\n<- ok\n-> M104 S200\n<- ok");
}

// Places of X and Y in millimetres while a line is executed.
std::vector<std::array<double, 2>> places_of(Printer& printer, std::string_view line) {
  std::vector<std::array<double, 2>> places;
  printer.send(line);
  printer.send("M400");
  for (int oks = 0; oks < 2;) {
    if (const auto reply = printer.reply(0.002); reply == "ok") ++oks;
    places.push_back({printer.mm(x), printer.mm(y)});
  }
  return places;
}

TEST(arc_commands, arcs_end_at_their_target_to_the_step_on_all_axes) {
  Printer printer;
  prepare(printer);
  printer.talk(R"(
    -> G1 X50 Y50 Z1 F6000
    <- ok
    -> G2 X60.0125 Y60 I10 J0 Z1.5 E0.5
    <- ok
    -> M400
    <- ok
    -> M114
    <* X:60.01 Y:60.00 Z:1.50 E:0.50
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[x], 4801);
  EXPECT_EQ(printer.chip.position[y], 4800);
  EXPECT_EQ(printer.chip.position[z], 3840);
  EXPECT_EQ(printer.chip.position[e], 250);
}

TEST(arc_commands, go_with_the_clock_by_g2_and_against_it_by_g3) {
  for (const bool clockwise : {true, false}) {
    Printer printer;
    prepare(printer);
    printer.talk("-> G1 X50 Y50 F6000\n<- ok\n-> M400\n<- ok");
    const auto places = places_of(printer, clockwise ? "G2 X70 I10 F1200" : "G3 X70 I10 F1200");
    const auto highest = std::ranges::max(places, {}, [](const auto& place) { return place[1]; });
    const auto lowest = std::ranges::min(places, {}, [](const auto& place) { return place[1]; });
    EXPECT_NEAR(highest[1], clockwise ? 60 : 50, 0.1);
    EXPECT_NEAR(lowest[1], clockwise ? 50 : 40, 0.1);
    EXPECT_NEAR((clockwise ? highest : lowest)[0], 60, 1.5);
    EXPECT_EQ(printer.chip.position[x], 5600);
  }
}

TEST(arc_commands, without_an_end_they_are_full_circles) {
  Printer printer;
  prepare(printer);
  printer.talk("-> G1 X50 Y50 F6000\n<- ok\n-> M400\n<- ok");
  const auto places = places_of(printer, "G3 I-5 J0 F1200");
  for (const auto& place : places) {
    EXPECT_NEAR(std::hypot(place[0] - 45, place[1] - 50), 5,
                0.3);  // the fake chip goes line by line
  }
  const auto leftmost = std::ranges::min(places, {}, [](const auto& place) { return place[0]; });
  EXPECT_NEAR(leftmost[0], 40, 0.1);
  EXPECT_EQ(printer.chip.position[x], 4000);
  EXPECT_EQ(printer.chip.position[y], 4000);
}

// A quarter of the circle with a positive radius, three of them with a negative one.
TEST(arc_commands, with_r_are_the_smaller_or_the_larger_part_of_the_circle) {
  for (const bool larger : {false, true}) {
    Printer printer;
    prepare(printer);
    printer.talk("-> G1 X50 Y50 F6000\n<- ok\n-> M400\n<- ok");
    const auto places =
        places_of(printer, larger ? "G2 X60 Y60 R-10 F1200" : "G2 X60 Y60 R10 F1200");
    const auto leftmost = std::ranges::min(places, {}, [](const auto& place) { return place[0]; });
    EXPECT_NEAR(leftmost[0], larger ? 40 : 50, 0.1);
    EXPECT_EQ(printer.chip.position[x], 4800);
    EXPECT_EQ(printer.chip.position[y], 4800);
  }
}

TEST(arc_commands, lie_in_the_plane_that_was_chosen) {
  Printer printer;
  prepare(printer);
  printer.talk(R"(
    -> G1 X50 Y50 Z20 F6000
    <- ok
    -> G18
    <- ok
    -> G2 X52 Z22 I2 F600
    <- ok
    -> G3 X50 Z20 I0 K-2
    <- ok
    -> G19
    <- ok
    -> G2 Y52 Z18 J0 K-2
    <- ok
    -> G17
    <- ok
    -> G2 X52 Y54 J2
    <- ok
    -> M400
    <- ok
    -> M114
    <* X:52.00 Y:54.00 Z:18.00
    <- ok
    -> G2 X50 Y50 I1 K1
    <- echo:I, J or K of another plane than the arc's, not executed: "G2 X50 Y50 I1 K1"
    <- ok
  )");
}

TEST(arc_commands, count_in_inches_and_from_where_they_are) {
  Printer printer;
  prepare(printer);
  printer.talk(R"(
    -> G1 X50 Y50 F6000
    <- ok
    -> G91
    <- ok
    -> G20
    <- ok
    -> G2 X1 Y-1 J-1 F100
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_NEAR(printer.mm(x), 75.4, 0.00626);
  EXPECT_NEAR(printer.mm(y), 24.6, 0.00626);
}

TEST(arc_commands, a_circle_that_touches_the_end_of_the_travel_is_not_beyond_it) {
  Printer printer;
  prepare(printer);
  printer.talk(R"(
    -> G1 X50.003 Y50.007 F6000
    <- ok
    -> G2 I-25.0015
    <- ok
    -> G2 J-25.0035
    <- ok
    -> G3 I-25.0017
    <* echo:Move beyond the end of X
    <- ok
    -> G2 J-25.0037
    <* echo:Move beyond the end of Y
    <- ok
    -> M400
    <- ok
  )");
}

TEST(arc_commands, a_cold_nozzle_draws_the_arc_without_extruding) {
  Printer printer;
  printer.talk(R"(
    -> G28
    <- ok
    -> G3 X20 Y20 R20 E5 F3000
    <- echo: cold extrusion prevented
    <- ok
    -> M400
    <- ok
    -> M114
    <* X:20.00 Y:20.00 Z:0.00 E:5.00
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[e], 0);
}

TEST(arc_commands, long_ones_are_stopped_in_the_middle) {
  Printer printer;
  printer.talk("-> G91\n<- ok");
  printer.send("G2 I9000 F60000");
  printer.run(10);
  EXPECT_FALSE(printer.chip.from_firmware.contains("ok"));
  printer.talk("-> M410\n<- ok\n<- ok\n-> M400\n<- ok");
  const auto stopped = printer.chip.position;
  EXPECT_NE(stopped[y], 0);
  printer.run(5);
  EXPECT_EQ(printer.chip.position, stopped);
  printer.talk("-> M114\n<* X:\n<- ok\n-> G1 X1\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], stopped[x] + 80);
  EXPECT_EQ(printer.chip.position[y], stopped[y]);
}

TEST(arc_commands, what_the_host_believes_after_a_stop_is_where_the_axes_are) {
  Printer printer;
  prepare(printer);
  printer.talk("-> G1 X100 Y100 F6000\n<- ok\n-> G92 X0 Y0\n<- ok");
  printer.send("G3 I20 F3000");
  printer.run(5);
  printer.talk(
      "-> M410\n<- ok\n<- ok\n-> M400\n<- ok\n-> G90\n<- ok\n-> G1 X0 Y0\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], 8000);
  EXPECT_EQ(printer.chip.position[y], 8000);
}

// M108 ends waits, and an arc is none.
TEST(arc_commands, are_not_ended_by_what_ends_waits) {
  Printer printer;
  prepare(printer);
  printer.talk("-> G1 X100 Y100 F6000\n<- ok");
  printer.send("G3 X60 Y100 I-20 F1200");
  printer.run(0.5);
  printer.talk("-> M108\n<- ok\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], 4800);
}

// v^2 / r: at 10 mm/s^2 and a radius of 10 mm no faster than 10 mm/s.
TEST(arc_commands, are_no_faster_than_the_acceleration_towards_the_centre_permits) {
  Printer printer;
  prepare(printer);
  printer.talk(
      "-> G1 X100 Y100 F6000\n<- ok\n-> M204 T10\n<- ok\n-> M205 X50 Y50\n<- ok\n-> M400\n<- ok");
  const auto began = printer.chip.time;
  printer.talk("-> G3 I10 F6000\n<- ok\n-> M400\n<- ok");
  EXPECT_GT(static_cast<double>(printer.chip.time - began) / clock_hz, 62.8 / 10);
}

}  // namespace
}  // namespace application_test
