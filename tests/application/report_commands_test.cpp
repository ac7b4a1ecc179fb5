// SPDX-License-Identifier: Apache-2.0
// What hosts ask around a print, settings, and lines that are no commands.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(report_commands, tells_what_it_is_and_can) {
  Printer printer;
  printer.send("M115");
  const auto first = printer.reply();
  ASSERT_TRUE(first.has_value());
  EXPECT_TRUE(first->starts_with("FIRMWARE_NAME:StepFabric")) << *first;
  bool autoreport = false;
  for (;;) {
    const auto line = printer.reply();
    ASSERT_TRUE(line.has_value());
    if (*line == "ok") break;
    EXPECT_TRUE(line->starts_with("Cap:")) << *line;
    autoreport |= *line == "Cap:AUTOREPORT_TEMP:1";
  }
  EXPECT_TRUE(autoreport);
}

TEST(report_commands, tells_which_end_stops_are_triggered) {
  Printer printer;
  printer.chip.mechanical[1] = 0;
  printer.talk(R"(
    -> M119
    <- Reporting endstop status
    <- x_min: open
    <- y_min: TRIGGERED
    <- z_min: open
    <- ok
  )");
}

TEST(report_commands, answers_unknown_commands_and_goes_on) {
  Printer printer;
  printer.talk(R"(
    -> G999
    <- echo:Unknown command: "G999"
    <- ok
    -> M20
    <- echo:Unknown command: "M20"
    <- ok
    -> T1
    <- echo:T1 Invalid extruder
    <- ok
    -> T0
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_executed, 1u);
  EXPECT_EQ(printer.counters.commands_refused, 3u);
}

TEST(report_commands, enters_the_boot_loader_at_rest_where_there_is_one) {
  Printer printer;
  printer.talk(R"(
    -> M997
    <- echo:No boot loader in this image, not executed: "M997"
    <- ok
  )");
  printer.chip.has_boot_loader = true;
  printer.send("G1 X5 F600");
  printer.send("M997");
  printer.run(0.2);
  EXPECT_EQ(printer.chip.boot_loader_entries, 0u);  // the move is still under way
  printer.run(5);
  EXPECT_EQ(printer.chip.boot_loader_entries, 1u);
}

TEST(report_commands, accepts_what_has_no_display_to_show_it) {
  Printer printer;
  printer.talk("-> M73 P10 R5\n<- ok\n-> M117 Hello G1 X5\n<- ok\n-> M110 N0\n<- ok");
}

TEST(report_commands, says_what_m118_is_given) {
  Printer printer;
  printer.talk(R"(
    -> M118 Hello
    <- Hello
    <- ok
    -> M118 E1 careful
    <- echo:careful
    <- ok
    -> M118 A1 action:pause
    <- //action:pause
    <- ok
  )");
}

TEST(report_commands, asks_the_host_to_pause_resume_or_cancel) {
  Printer printer;
  printer.talk(R"(
    -> M25
    <- //action:pause
    <- ok
    -> M24
    <- //action:resume
    <- ok
    -> M524
    <- //action:cancel
    <- ok
  )");
}

TEST(report_commands, reports_positions_by_itself_after_m154) {
  Printer printer;
  printer.talk(R"(
    -> M154 S1
    <- ok
    <* X:0.00 Y:0.00 Z:0.00 E:0.00 Count
    <* X:0.00 Y:0.00 Z:0.00 E:0.00 Count
    -> M154 S0
    <- ok
  )");
  EXPECT_FALSE(printer.reply(3).has_value());
}

TEST(report_commands, numbered_lines_and_resends_reach_the_executor) {
  Printer printer;
  printer.talk(R"(
    -> N0 M110 N0*125
    <- ok
    -> N1 M118 one*96
    <* Error:checksum mismatch, Last Line: 0
    <- Resend: 1
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_executed, 1u);
}

TEST(report_commands, a_line_of_which_bytes_were_lost_is_not_executed) {
  Printer printer;
  printer.send("M118 one");
  printer.run(0.1);
  printer.chip.gap_before_next_byte = true;
  printer.send("M118 two");
  printer.talk(R"(
    <- one
    <- ok
    <- echo:Line damaged on the serial line, not executed
    <- ok
    -> M118 three
    <- three
    <- ok
  )");
}

TEST(setting_commands, take_what_sliced_files_begin_with) {
  Printer printer;
  printer.talk(R"(
    -> M201 X500 Y500 Z100 E5000
    <- ok
    -> M203 X500 Y500 Z10 E60
    <- ok
    -> M204 P500 R1000 T500
    <- ok
    -> M205 X8.00 Y8.00 Z0.40 E5.00
    <- ok
    -> M205 S0 T0
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 0u);
}

TEST(setting_commands, refuse_values_that_cannot_be) {
  Printer printer;
  printer.talk("-> M201 X0\n<* not executed\n<- ok\n-> M203 Y-5\n<* not executed\n<- ok");
  EXPECT_EQ(printer.counters.commands_refused, 2u);
}

TEST(setting_commands, m92_changes_the_steps_of_later_moves) {
  Printer printer;
  printer.talk(R"(
    -> G28
    <- ok
    -> M92
    <- echo: M92 X80.00 Y80.00 Z2560.00 E500.00
    <- ok
    -> M92 X100
    <- ok
    -> G1 X10 F3000
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[0], 1000);
}

TEST(setting_commands, m113_tells_and_sets_the_busy_interval) {
  Printer printer;
  printer.talk(
      "-> M113\n<- echo:M113 S2\n<- ok\n-> M113 S5\n<- ok\n-> M113\n<- echo:M113 S5\n<- ok");
}

TEST(report_commands, says_busy_every_two_seconds_while_it_dwells) {
  Printer printer;
  printer.send("G4 S7");
  printer.run(6.5);
  std::size_t count = 0;
  for (std::size_t at = 0;
       (at = printer.chip.from_firmware.find("echo:busy: processing", at)) != std::string::npos;
       ++at) {
    ++count;
  }
  EXPECT_EQ(count, 3u);
}

}  // namespace
}  // namespace application_test
