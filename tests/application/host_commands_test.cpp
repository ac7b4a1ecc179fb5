// SPDX-License-Identifier: Apache-2.0
// Texts, requests and signs of life for the host, and lines that are no commands.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(host_commands, answers_unknown_commands_and_goes_on) {
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

TEST(host_commands, enters_the_boot_loader_at_rest_where_there_is_one) {
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

TEST(host_commands, accepts_what_has_no_display_to_show_it) {
  Printer printer;
  printer.talk("-> M73 P10 R5\n<- ok\n-> M117 Hello G1 X5\n<- ok\n-> M110 N0\n<- ok");
}

TEST(host_commands, says_what_m118_is_given) {
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
TEST(host_commands, says_no_text_that_reads_as_an_answer) {
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

TEST(host_commands, asks_the_host_to_pause_resume_or_cancel) {
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

TEST(host_commands, numbered_lines_and_resends_reach_the_executor) {
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

TEST(host_commands, a_line_of_which_bytes_were_lost_is_not_executed) {
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

TEST(host_commands, says_busy_within_two_seconds_while_it_dwells) {
  Printer printer;
  printer.send("G4 S7");
  printer.run(6.5);
  std::size_t count = 0;
  for (std::size_t at = 0;
       (at = printer.chip.from_firmware.find("echo:busy: processing", at)) != std::string::npos;
       ++at) {
    ++count;
  }
  EXPECT_EQ(count, 6u);  // after half of the interval
}

}  // namespace
}  // namespace application_test
