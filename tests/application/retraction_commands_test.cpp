// SPDX-License-Identifier: Apache-2.0
// G10, G11, M207 and M208, as dialogues and by the positions of the axes.
#include "tests/application/retraction.hpp"

namespace application_test {
namespace {

TEST_F(Retraction, draws_back_3_mm_by_default_and_pushes_them_forward) {
  execute({"G10"});
  expect(17, 5);
  execute({"G11"});
  expect(20, 5);
}

TEST_F(Retraction, happens_once_however_often_it_is_sent) {
  execute({"G11", "G10", "G10", "G10 S1"});
  expect(17, 5);
  execute({"G11", "G11"});
  expect(20, 5);
}

TEST_F(Retraction, takes_length_lift_and_extra_from_m207_and_m208) {
  execute({"M207 S1.2 Z0.6", "M208 S0.1", "G10"});
  expect(18.8, 5.6);
  execute({"G11"});
  expect(20.1, 5);
}

TEST_F(Retraction, ends_with_the_length_and_lift_that_it_began_with) {
  execute({"M207 S1 Z0.5", "G10", "M207 S4 Z2", "G11"});
  expect(20, 5);
}

TEST_F(Retraction, leaves_the_hosts_coordinates_as_they_are) {
  execute({"M207 S2 Z1", "G10"});
  talk("-> M114\n<* X:10.00 Y:10.00 Z:5.00 E:20.00\n<- ok");
  execute({"G1 X50 Z6", "G1 X60 E21"});
  expect(19, 7);
  execute({"G11", "G1 E22"});
  expect(22, 6);
}

TEST_F(Retraction, keeps_its_lift_through_g92) {
  execute({"M207 S2 Z1", "G10", "G92 Z100 E0", "G11", "G1 E1 Z101"});
  expect(21, 6);
}

// 30 mm at 10 mm/s take 3 s; flow and speed factors change neither length nor speed.
TEST_F(Retraction, runs_at_its_own_speed_and_length) {
  execute({"M207 S30 F600", "M208 F1800", "M221 S50", "G1 F60"});
  const auto began = printer.chip.time;
  execute({"G10"});
  const auto drawn = printer.chip.time;
  execute({"G11"});
  EXPECT_NEAR(static_cast<double>(drawn - began) / clock_hz, 3.0, 0.2);
  EXPECT_NEAR(static_cast<double>(printer.chip.time - drawn) / clock_hz, 1.0, 0.2);
  expect(20, 5);
}

TEST_F(Retraction, does_not_change_the_feedrate_of_later_moves) {
  execute({"G1 X20 F600", "G10", "G11"});
  const auto began = printer.chip.time;
  execute({"G1 X30"});
  EXPECT_NEAR(static_cast<double>(printer.chip.time - began) / clock_hz, 1.0, 0.1);
}

TEST_F(Retraction, is_refused_where_z_cannot_be_lifted) {
  execute({"M207 Z2", "G1 Z109 F600"});
  talk(R"(
    -> G10
    <- echo:Move beyond the end of Z (0.00 to 110.00), not executed: "G10"
    <- ok
  )");
  execute({"G11"});
  expect(20, 109);
}

TEST_F(Retraction, is_refused_below_the_extrusion_limit) {
  execute({"M302 S250"});
  talk("-> G10\n<- echo: cold extrusion prevented\n<- ok\n");
  execute({"M302 S170", "G10", "M302 S250"});
  talk("-> G11\n<- echo: cold extrusion prevented\n<- ok\n");
  expect(17, 5);
  execute({"M302 S170", "G11"});
  expect(20, 5);
}

TEST_F(Retraction, with_a_letter_of_another_meaning_of_g10_is_refused) {
  talk(R"(
    -> G10 L2 P1 X5
    <- echo:Unknown parameter, not executed: "G10 L2 P1 X5"
    <- ok
  )");
}

TEST_F(Retraction, is_exact_over_many_times) {
  execute({"M207 S0.7 Z0.3"});
  for (int i = 0; i < 200; ++i) execute({"G10", "G1 X11", "G11", "G1 X10"});
  expect(20, 5);
}

TEST_F(Retraction, reports_and_restores_its_settings) {
  talk(R"(
    -> M207
    <- echo: M207 S3.00 F2700.00 Z0.00
    <- ok
    -> M208
    <- echo: M208 S0.00 F480.00
    <- ok
    -> M207 S0.8 F2400 Z0.25 W9
    <- ok
    -> M208 S-0.05 F1200
    <- ok
    -> M207
    <- echo: M207 S0.80 F2400.00 Z0.25
    <- ok
    -> M208
    <- echo: M208 S-0.05 F1200.00
    <- ok
    -> M502
    <- echo:Hardcoded Default Settings Loaded
    <- ok
    -> M207
    <- echo: M207 S3.00 F2700.00 Z0.00
    <- ok
  )");
}

TEST_F(Retraction, refuses_a_line_with_a_value_that_cannot_be_as_a_whole) {
  for (const char* line : {"M207 S-1 Z1", "M207 Z-0.1 S1", "M207 S1 F0", "M207 S1 F-5",
                           "M207 S100.1", "M207 S1 F700000000"}) {
    printer.send(line);
    const auto said = printer.reply();
    ASSERT_TRUE(said.has_value());
    EXPECT_TRUE(said->contains("out of range, not executed")) << line << ": " << *said;
    EXPECT_EQ(printer.reply(), "ok");
  }
  talk("-> M207\n<- echo: M207 S3.00 F2700.00 Z0.00\n<- ok\n");
}

TEST_F(Retraction, takes_inches_after_g20) {
  execute({"G20", "M207 S0.1 Z0.1", "G10", "G21"});
  expect(20 - 2.54, 5 + 2.54);
}

// The limits are Marlin's: 0.1 to 10 mm.
TEST_F(Retraction, stands_for_moves_of_e_alone_after_m209) {
  execute({"M207 S3 Z0.5", "M209 S1", "G1 E19.2 F2400"});
  expect(17, 5.5);
  talk("-> M114\n<* X:10.00 Y:10.00 Z:5.00 E:19.20\n<- ok");
  execute({"G1 X20 F6000", "G0 E20"});
  expect(20, 5);
  execute({"G1 E9.9"});
  expect(9.9, 5);
  execute({"G1 E9.8", "G1 E9.9", "M83", "G1 E-10", "G1 E10"});
  expect(9.9, 5);
  execute({"G1 E-0.09"});
  expect(9.81, 5);
}

TEST_F(Retraction, of_m209_leaves_other_moves_as_they_are) {
  execute({"M207 S3 Z0.5", "M83", "M209 S1", "G1 X20 E-1 F6000", "G1 Z6 E-1", "G1 E1 F2400"});
  expect(19, 6);
  execute({"G1 E-1", "G1 E-1"});  // drawn back already
  expect(15, 6.5);
  execute({"G1 E2"});
  expect(18, 6);
  execute({"M209 S0", "G1 E-2"});
  expect(16, 6);
}

TEST_F(Retraction, of_m209_and_of_g10_are_one) {
  execute({"M209 S1", "M83", "G10", "G1 E1", "G1 E-1", "G11", "G11"});
  expect(20, 5);
}

TEST_F(Retraction, of_m209_takes_the_feedrate_and_does_not_run_at_it) {
  execute({"M207 S6 F3600", "M209 S1"});
  const auto began = printer.chip.time;
  execute({"G1 E18 F60"});
  EXPECT_LT(static_cast<double>(printer.chip.time - began) / clock_hz, 0.5);
  execute({"G1 E20", "G1 X10 F6000", "G1 E18 F600"});
  const auto drawn = printer.chip.time;
  execute({"G1 X20"});
  EXPECT_NEAR(static_cast<double>(printer.chip.time - drawn) / clock_hz, 1.0, 0.1);
}

// So the host's next absolute E still means what it says.
TEST_F(Retraction, of_m209_that_is_refused_leaves_the_hosts_e) {
  execute({"M209 S1", "M302 S250"});
  talk("-> G1 E18\n<- echo: cold extrusion prevented\n<- ok\n-> M114\n<* E:20.00\n<- ok");
  execute({"M302 S170", "G1 E20", "G1 E20.05"});
  expect(20.05, 5);
}

TEST_F(Retraction, of_m209_is_exact_over_many_times) {
  execute({"M207 S0.7 Z0.3", "M209 S1", "M83"});
  for (int i = 0; i < 200; ++i) execute({"G1 E-0.8", "G1 X11", "G1 E0.8", "G1 X10 E0.01"});
  expect(22, 5);
}

TEST_F(Retraction, of_m209_is_reported_and_ends_with_m502) {
  talk(R"(
    -> M209
    <- echo: M209 S0
    <- ok
    -> M209 S1
    <- ok
    -> M209
    <- echo: M209 S1
    <- ok
    -> M502
    <- echo:Hardcoded Default Settings Loaded
    <- ok
    -> M209
    <- echo: M209 S0
    <- ok
  )");
}

}  // namespace
}  // namespace application_test
