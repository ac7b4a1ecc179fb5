// SPDX-License-Identifier: Apache-2.0
// What the host and its user may do ahead of the lines that wait, and what happens when they
// are gone.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(host_actions, m0_asks_the_user_with_a_button_until_m108) {
  Printer printer;
  printer.talk(R"(
    -> M0 Change the filament
    <- //action:prompt_begin Waiting for the user
    <- //action:prompt_button Continue
    <- //action:prompt_show
  )");
  EXPECT_FALSE(printer.reply(60).has_value());
  printer.talk(R"(
    -> M108
    <- //action:prompt_end
    <- ok
    <- ok
  )");
}

TEST(host_actions, says_that_it_is_the_user_for_whom_it_waits) {
  Printer printer;
  printer.send("M1");
  printer.run(5);
  EXPECT_NE(printer.chip.from_firmware.find("echo:busy: paused for user"), std::string::npos);
}

TEST(host_actions, the_button_of_the_prompt_goes_on) {
  Printer printer;
  printer.send("M0");
  printer.run(1);
  printer.chip.from_firmware.clear();
  printer.talk("-> M876 S0\n<- //action:prompt_end\n<- ok\n<- ok");
}

TEST(host_actions, a_button_without_a_prompt_ends_no_wait) {
  Printer printer;
  printer.send("G4 S5");
  printer.run(1);
  printer.send("M876 S0");
  EXPECT_FALSE(printer.reply(3).has_value());
  printer.talk("<- ok\n<- ok");
}

TEST(host_actions, m0_with_a_time_goes_on_by_itself) {
  Printer printer;
  printer.send("M0 S2");
  printer.run(1.9);
  EXPECT_EQ(printer.chip.from_firmware.find("prompt_end"), std::string::npos);
  printer.run(0.2);
  EXPECT_NE(printer.chip.from_firmware.find("prompt_end\nok\n"), std::string::npos);
}

TEST(host_actions, a_filament_change_ends_the_moves_and_waits_for_the_user) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> G1 X20 F3000\n<- ok");
  printer.send("M600 E-20 X0 Y0");
  printer.talk(R"(
    <- //action:paused
    <- //action:prompt_begin Change the filament
    <- //action:prompt_button Continue
    <- //action:prompt_show
  )");
  EXPECT_EQ(printer.chip.position[0], 1600);
  printer.send("G1 X40");
  printer.run(60);
  EXPECT_NE(printer.chip.from_firmware.find("echo:busy: paused for user"), std::string::npos);
  EXPECT_EQ(printer.chip.position[0], 1600);
  printer.chip.from_firmware.clear();
  printer.talk("-> M108\n<- //action:prompt_end\n<- //action:resumed\n<- ok\n<- ok\n<- ok");
  printer.talk("-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[0], 3200);
  EXPECT_EQ(printer.counters.commands_refused, 0u);
}

TEST(host_actions, m601_pauses_until_m602_the_button_or_the_resume_of_the_host) {
  for (const char* go_on : {"M602", "M108", "M876 S0", "//action:resume"}) {
    Printer printer;
    // A time is for M0 and M1.
    printer.talk(R"(
      -> M601 S2
      <- //action:paused
      <- //action:prompt_begin Paused
      <- //action:prompt_button Continue
      <- //action:prompt_show
    )");
    EXPECT_FALSE(printer.reply(20).has_value());
    printer.send(go_on);
    printer.talk("<- //action:prompt_end\n<- //action:resumed\n<- ok\n<- ok");
  }
}

TEST(host_actions, m602_without_a_pause_does_nothing) {
  Printer printer;
  printer.talk("-> M602\n<- ok");
  EXPECT_EQ(printer.counters.commands_refused, 0u);
}

TEST(host_actions, heaters_stay_on_while_the_user_is_waited_for_and_the_host_is_heard) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M86 S20\n<- ok\n-> M104 S100\n<- ok");
  printer.send("M600");
  for (int i = 0; i < 6; ++i) {
    printer.run(10);
    printer.send("M105");
  }
  EXPECT_EQ(printer.chip.from_firmware.find("heaters off"), std::string::npos);
  printer.run(25);
  EXPECT_NE(printer.chip.from_firmware.find("heaters off"), std::string::npos);
}

TEST(host_actions, a_pause_holds_the_lines_that_wait_until_resume) {
  Printer printer;
  printer.talk("-> //action:pause\n<- ok");
  printer.send("M118 one");
  printer.send("M118 two");
  printer.run(5);
  EXPECT_NE(printer.chip.from_firmware.find("echo:busy: paused for user"), std::string::npos);
  EXPECT_EQ(printer.chip.from_firmware.find("one"), std::string::npos);
  printer.chip.from_firmware.clear();
  printer.talk(
      "-> //action:resume\n<- one\n<- ok\n<- two\n<- ok\n<- ok\n-> M118 three\n<- three\n<- ok");
}

TEST(host_actions, cancel_ends_the_motion_and_answers_what_waits_without_executing_it) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> G1 X100 F600\n<- ok");
  printer.send("G4 S60");
  printer.send("G1 X150");
  printer.send("M118 never");
  printer.run(1);
  printer.send("//action:cancel");
  printer.talk("<- ok\n<- ok\n<- ok\n<- ok\n-> M118 after\n<- after\n<- ok");
  printer.run(1);
  EXPECT_LT(printer.mm(0), 30);
}

TEST(host_actions, a_pause_outlives_its_host_and_the_next_one_learns_how_to_go_on) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> //action:pause\n<- ok");
  // The host is gone, with these lines unanswered: as many as may wait.
  for (int i = 1; i <= 8; ++i) printer.send("G1 F3000 X" + std::to_string(i));
  printer.run(60);
  printer.chip.from_firmware.clear();
  // printcore, OctoPrint, Cura, each more often than lines may wait.
  for (int i = 0; i < 10; ++i) {
    printer.talk(R"(
      -> M105
      <* ok T:
      -> N0 M110 N0*125
      <- echo:Paused: M108 goes on, //action:cancel ends
      <- ok
      -> N1M115*7
      <- echo:Paused: M108 goes on, //action:cancel ends
      <* FIRMWARE_NAME:StepFabric
    )");
    for (auto line = printer.reply(); line != "ok"; line = printer.reply()) {
      ASSERT_TRUE(line.has_value());
    }
    printer.talk("-> M114\n<* X:0.00 Y:0.00 Z:0.00 E:0.00 Count\n<- ok");
  }
  EXPECT_EQ(printer.chip.position[0], 0);
  printer.send("M108");
  printer.run(10);
  EXPECT_EQ(printer.mm(0), 8);
}

TEST(host_actions, a_prompt_outlives_its_host_too) {
  Printer printer;
  printer.send("M600");
  printer.run(60);
  printer.chip.from_firmware.clear();
  printer.talk(R"(
    -> N0 M110 N0*125
    <- echo:Paused: M108 goes on, //action:cancel ends
    <- ok
    -> M105
    <* ok T:
    -> M108
    <- //action:prompt_end
    <- //action:resumed
    <- ok
    <- ok
  )");
}

// From the line's end to its ok, and between signs of life on the way, in milliseconds.
int longest_silence_ms(Printer& printer, std::string_view line) {
  printer.chip.from_firmware.clear();
  printer.send(line);
  int longest = 0, silent = 0;
  std::size_t seen = 0;
  for (int ms = 0; ms < 200'000; ++ms) {
    printer.run(0.001);
    ++silent;
    const std::string& said = printer.chip.from_firmware;
    const std::size_t end = said.rfind('\n');
    if (end == std::string::npos || end < seen) continue;
    const std::string fresh = said.substr(seen, end + 1 - seen);
    seen = end + 1;
    const bool done = fresh.starts_with("ok") || fresh.find("\nok") != std::string::npos;
    if (!done && fresh.find("echo:busy") == std::string::npos) continue;
    longest = std::max(longest, silent);
    silent = 0;
    if (done) return longest;
  }
  ADD_FAILURE() << "no ok to " << line;
  return longest;
}

TEST(host_actions, every_line_is_answered_or_called_busy_within_two_seconds) {
  Printer printer;
  printer.run(0.3);
  for (const char* line :
       {"", "; only a comment", "M105", "M115", "G28", "G4 S9", "G1 X150 F300", "M400", "M109 S60",
        "M190 R40", "M0 S7", "G999", "N5 G1", "M117 text", "G1 X0 F600", "M84"}) {
    EXPECT_LE(longest_silence_ms(printer, line), 2000) << line;
  }
}

TEST(host_actions, heaters_are_switched_off_when_the_host_says_nothing_for_the_time_of_m86) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M86\n<- echo:M86 S1800\n<- ok\n-> M86 S20\n<- ok\n-> M104 S200\n<- ok");
  EXPECT_FALSE(printer.reply(15).has_value());
  EXPECT_GT(printer.chip.heater_duty(0), 0u);
  printer.talk("-> M105\n<* ok T:");
  EXPECT_FALSE(printer.reply(15).has_value());
  printer.talk("<- echo:No word from the host, heaters off");
  printer.run(1);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  EXPECT_FALSE(printer.reply(60).has_value());
}

TEST(host_actions, a_host_killed_during_m109_leaves_a_printer_that_cools_down) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M86 S20\n<- ok");
  printer.send("M109 S150");
  // No host reads or sends any more; a wait for heat counts as work, not as silence.
  printer.run(120);
  EXPECT_NE(printer.chip.from_firmware.find("\nok\n"), std::string::npos);
  EXPECT_NE(printer.chip.from_firmware.find("echo:No word from the host, heaters off"),
            std::string::npos);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
}

TEST(host_actions, work_is_no_silence) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M86 S5\n<- ok\n-> M104 S200\n<- ok\n-> G4 S20\n<- ok");
}

}  // namespace
}  // namespace application_test
