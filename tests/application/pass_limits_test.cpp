// SPDX-License-Identifier: Apache-2.0
// How much one pass of the loop does at most: what its bound in clocks rests on.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/application/dialogue.hpp"

namespace {

constexpr std::ptrdiff_t most_lines = 4;
constexpr std::size_t most_bytes = 128;
constexpr std::uint32_t most_lines_of_motion = 2;
constexpr unsigned most_short_passes = 8;

class PassLimits : public testing::Test {
 protected:
  PassLimits() { printer.run(0.3); }

  std::ptrdiff_t lines_waiting() const { return std::ranges::count(printer.chip.to_firmware, '\n'); }

  // So many short lines are planned, and motion waits for more.
  void plan(int lines) {
    printer.talk("-> M201 X50000 Y50000\n<- ok\n-> G91\n<- ok\n-> G1 F6000\n<- ok\n");
    for (int i = 0; i < lines; ++i) {
      printer.send(i % 2 == 0 ? "G1 X0.05" : "G1 Y0.05");
      printer.pass_without_sleep();
    }
  }

  application_test::Printer printer;
};

TEST_F(PassLimits, four_lines_from_the_host) {
  for (int i = 0; i < 10; ++i) printer.send("G92 E0");
  for (std::ptrdiff_t left = 10 - most_lines; left >= 0; left -= most_lines) {
    printer.pass_without_sleep();
    EXPECT_EQ(lines_waiting(), left);
  }
}

TEST_F(PassLimits, bytes_from_the_host) {
  printer.send(std::string(300, 'x'));
  const std::size_t before = printer.chip.to_firmware.size();
  printer.pass_without_sleep();
  EXPECT_EQ(printer.chip.to_firmware.size(), before - most_bytes);
}

TEST_F(PassLimits, one_line_of_a_long_reply) {
  for (const char* command : {"M503", "M115", "M119", "M78"}) {
    printer.send(command);
    std::ptrdiff_t lines = 0;
    for (int pass = 0; pass < 60; ++pass) {
      printer.pass_without_sleep();
      std::ptrdiff_t said = std::ranges::count(printer.chip.from_firmware, '\n');
      if (printer.chip.from_firmware.ends_with("ok\n")) --said;
      EXPECT_LE(said, 1) << command << printer.chip.from_firmware;
      lines += said;
      printer.chip.from_firmware.clear();
    }
    EXPECT_GE(lines, 2) << command;
  }
}

TEST_F(PassLimits, two_lines_of_motion_from_rest_until_enough_is_handed_over) {
  plan(32);
  const std::uint32_t before = printer.chip.lines_begun;
  std::uint32_t handed_over = 0;
  for (unsigned pass = 0; pass < most_short_passes; ++pass) {
    const std::uint32_t begun = printer.chip.lines_begun;
    printer.pass_without_sleep();
    EXPECT_LE(printer.chip.lines_begun - begun, most_lines_of_motion);
    handed_over = printer.chip.lines_begun - before;
  }
  EXPECT_GE(handed_over + before, 8u);
  EXPECT_EQ(printer.chip.underruns, 0u);
}

TEST_F(PassLimits, no_command_while_motion_is_behind) {
  plan(32);
  printer.chip.from_firmware.clear();
  // Motion begins in this pass, and more of it is due.
  while (printer.chip.lines_begun == 0) printer.pass_without_sleep();
  for (int i = 0; i < 4; ++i) printer.send("G92 E0");
  const std::uint32_t executed = printer.counters.commands_executed;
  const std::uint32_t begun = printer.chip.lines_begun;
  printer.pass_without_sleep();
  ASSERT_EQ(printer.chip.lines_begun - begun, most_lines_of_motion);
  EXPECT_EQ(printer.counters.commands_executed, executed);
  printer.run(0.1);
  EXPECT_GE(printer.counters.commands_executed, executed + 4);
}

}  // namespace
