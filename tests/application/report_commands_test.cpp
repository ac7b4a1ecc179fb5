// SPDX-License-Identifier: Apache-2.0
// What hosts ask around a print, and lines that are no commands.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(report_commands, reports_what_it_is_and_can) {
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

TEST(report_commands, reports_which_end_stops_are_triggered) {
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

// In Marlin's words, by which OctoPrint knows it; the print goes on with the tool that there is.
TEST(report_commands, refuses_a_tool_that_is_not_there_aloud) {
  Printer printer;
  printer.talk(R"(
    -> T2
    <- echo:T2 Invalid extruder
    <- ok
    -> M104 T1 S200
    <- echo:M104 Invalid extruder 1
    <- ok
    -> T0
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 2u);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
}

// There is no card: what would be stored on it is not a print either.
TEST(report_commands, executes_nothing_between_m28_and_m29) {
  Printer printer;
  printer.talk(R"(
    -> M28 part.gco
    <- echo:No SD card until M29, not executed: "M28 part.gco"
    <- ok
    -> G28
    <- echo:No SD card until M29, not executed: "G28"
    <- ok
    -> M104 S200
    <- echo:No SD card until M29, not executed: "M104 S200"
    <- ok
    -> M105
    <* ok T:
    -> M114
    <* X:
    <- ok
    -> M119
    <- Reporting endstop status
    <* x_min
    <* y_min
    <* z_min
    <- ok
    -> M110 N3
    <- ok
    -> M29 part.gco
    <- echo:No SD card, not executed: "M29 part.gco"
    <- ok
    -> M118 on
    <- on
    <- ok
  )");
  EXPECT_EQ(printer.chip.motors, 0u);
  EXPECT_EQ(printer.counters.commands_refused, 4u);
}

// A host that comes into the midst of it gets online.
TEST(report_commands, says_what_it_is_between_m28_and_m29) {
  Printer printer;
  printer.talk(R"(
    -> M28 part.gco
    <- echo:No SD card until M29, not executed: "M28 part.gco"
    <- ok
    -> M115
    <* FIRMWARE_NAME:StepFabric
  )");
}

TEST(report_commands, says_that_files_of_a_card_and_repeats_are_not_there) {
  Printer printer;
  printer.talk(R"(
    -> M32 part.gco
    <- echo:No SD card, not executed: "M32 part.gco"
    <- ok
    -> M24
    <- echo:No SD card, not executed: "M24"
    <- ok
    -> M808 L5
    <- echo:No repeats, the lines behind it are executed once, not executed: "M808 L5"
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 3u);
}

TEST(report_commands, does_not_go_on_with_m24_where_m23_was_refused) {
  Printer printer;
  printer.talk(R"(
    -> M23 part.gco
    <- echo:No SD card, not executed: "M23 part.gco"
    <- ok
    -> M24
    <- echo:No SD card, not executed: "M24"
    <- ok
    -> M24
    <- //action:resume
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 2u);
}

TEST(report_commands, reports_no_temperature_before_there_is_one) {
  Printer printer;
  printer.send("M105");
  const auto answer = printer.reply();
  ASSERT_TRUE(answer.has_value());
  EXPECT_TRUE(answer->starts_with("ok T:25.")) << *answer;
}

TEST(report_commands, ends_its_name_where_octoprint_and_cura_do) {
  Printer printer;
  printer.send("M115");
  const auto line = printer.reply();
  ASSERT_TRUE(line.has_value());
  // OctoPrint takes what stands before the next key, Cura what stands before the last semicolon.
  EXPECT_TRUE(line->starts_with("FIRMWARE_NAME:StepFabric PROTOCOL_VERSION:")) << *line;
  EXPECT_TRUE(line->contains(';')) << *line;
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

// A host would take it for one, and count one line too many as done.
TEST(report_commands, says_no_text_that_reads_as_an_answer) {
  Printer printer;
  printer.talk(R"(
    -> M118 ok T:20
    <- echo:ok T:20
    <- ok
    -> M118 Resend: 3
    <- echo:Resend: 3
    <- ok
    -> M118 rs 3
    <- echo:rs 3
    <- ok
    -> M118 OK
    <- echo:OK
    <- ok
    -> M118 START
    <- echo:START
    <- ok
    -> M118 A1 ok
    <- //ok
    <- ok
    -> M118 o
    <- o
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
    <* echo:checksum mismatch, asked for again
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
