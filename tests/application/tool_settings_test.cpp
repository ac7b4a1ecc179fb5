// SPDX-License-Identifier: Apache-2.0
// M217, M218, M605, and settings that each tool has for itself.
#include "tests/application/two_tools.hpp"

namespace application_test {
namespace {

TEST_F(TwoTools, have_offsets_that_m218_sets) {
  printer.talk(R"(
    -> M218
    <- echo: M218 T1 X20.000 Y1.000 Z-0.250
    <- ok
    -> M218 T1 X18.125 Z0
    <- ok
    -> M218
    <- echo: M218 T1 X18.125 Y1.000 Z0.000
    <- ok
    -> M218 T2 X5
    <- echo:M218 Invalid extruder 2
    <- ok
  )");
  execute({"G1 X100 Y50 Z10 F6000", "T1"});
  expect_steps(81.875, 49, 10, 0, 0);
  // Of the tool in use: its nozzle is where it is, and only called otherwise.
  execute({"M218 X20"});
  printer.talk("-> M114\n<* X:101.88 Y:50.00 Z:10.00\n<- ok");
  execute({"T0"});
  expect_steps(101.875, 50, 10, 0, 0);
}

TEST_F(TwoTools, have_settings_that_are_listed_and_restored) {
  printer.talk(R"(
    -> M217 S300 B20 E-1 P6000 R0 Z500
    <- echo: M217 S200.00 B10.00 E0.00 P5400.00 R10.02 U1200.00 Z110.00
    <- ok
    -> M218 T1 Y3
    <- ok
    -> M503
    <* M92
    <* M203
    <* M201
    <* M204
    <* M205
    <* M207
    <* M208
    <* M209
    <- echo: M217 S200.00 B10.00 E0.00 P5400.00 R10.02 U1200.00 Z110.00
    <- echo: M218 T1 X20.000 Y3.000 Z-0.250
    <- ok
    -> M502
    <* Hardcoded
    <- ok
    -> M217
    <- echo: M217 S0.00 B0.00 E0.00 P300.00 R2400.00 U1200.00 Z0.00
    <- ok
    -> M218
    <- echo: M218 T1 X20.000 Y1.000 Z-0.250
    <- ok
  )");
}

TEST_F(TwoTools, prime_with_m217_q) {
  printer.talk("-> M217 E3\n<* E3.00\n<- ok");
  execute({"G1 X100 Y50 Z10 F6000", "M217 Q"});
  expect_steps(100, 50, 10, 3, 0);
  execute({"T1"});  // and at each change
  expect_steps(80, 49, 10.25, 3, 3);
}

// What of it has come out is not the host's, as where it ends by itself.
TEST_F(TwoTools, keep_the_hosts_e_where_a_stop_ends_m217_q) {
  printer.talk("-> M217 E20 P300\n<* E20.00\n<- ok");
  execute({"G1 E1 F300"});
  printer.send("M217 Q");
  printer.run(1);
  printer.talk("-> M410\n<- ok\n<- ok\n-> M114\n<* E:1.00\n<- ok");
  EXPECT_LT(printer.mm(3), 10);
  const double there = printer.mm(3);
  execute({"G1 E2"});
  EXPECT_NEAR(printer.mm(3), there + 1, 0.005);
}

TEST_F(TwoTools, do_not_duplicate) {
  printer.talk(R"(
    -> M605
    <- echo:One tool extrudes at a time
    <- ok
    -> M605 S1
    <- echo:One tool extrudes at a time
    <- ok
    -> M605 S2
    <- echo:No duplication: one tool extrudes at a time, not executed: "M605 S2"
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 1u);
}

TEST_F(TwoTools, have_a_flow_each) {
  printer.talk(R"(
    -> M221 S50 T1
    <- ok
    -> M221
    <- echo:E0 Flow: 100%
    <- ok
    -> M221 T1
    <- echo:E1 Flow: 50%
    <- ok
    -> M221 S50 T3
    <- echo:M221 Invalid extruder 3
    <- ok
  )");
  execute({"G1 X100 Y50 Z10 F6000", "M83", "G1 E4 F300", "T1", "G1 E4"});
  expect_steps(80, 49, 10.25, 4, 2);
}

// 2.405 mm³ are a millimetre of 1.75 mm.
TEST_F(TwoTools, have_a_filament_each) {
  execute({"G1 X100 Y50 Z10 F6000", "M83", "M200 T0 D1.75", "M200 T1 D3.5"});
  printer.talk("-> M200\n<- M200 S1 T0 D1.750 T1 D3.500\n<- ok");
  execute({"G1 E24.05282 F300", "T1", "G1 E24.05282"});
  expect_steps(80, 49, 10.25, 10, 2.5);
  execute({"M200 T1 D0"});  // mm again, for both
  execute({"G1 E1", "T0", "G1 E1"});
  expect_steps(100, 50, 10, 11, 3.5);
}

TEST_F(TwoTools, are_retracted_each_by_itself) {
  execute({"G1 X100 Y50 Z10 F6000", "M207 S2", "G10", "T1"});
  expect_steps(80, 49, 10.25, -2, 0);
  execute({"G11"});  // has nothing to end
  expect_steps(80, 49, 10.25, -2, 0);
  execute({"G10", "T0", "G11"});
  expect_steps(100, 50, 10, 0, -2);
}

TEST(two_tools, are_counted_for_the_host) {
  Printer printer(machine_with_two_tools());
  printer.talk("-> M115\n<* EXTRUDER_COUNT:2");
}

// A file for two extruders is not printed with one.
TEST(one_tool, knows_no_other) {
  Printer printer;
  printer.talk(R"(
    -> T0
    <- ok
    -> T1
    <- echo:T1 Invalid extruder
    <- ok
    -> M217 S4
    <- echo:M217 not fitted
    <- ok
    -> M218 T1 X5
    <- echo:M218 not fitted
    <- ok
    -> M605 S2
    <- echo:M605 not fitted
    <- ok
  )");
}

}  // namespace
}  // namespace application_test
