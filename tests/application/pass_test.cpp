// SPDX-License-Identifier: Apache-2.0
// How much one pass of the loop takes on.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

using testing::HasSubstr;

class Pass : public testing::Test {
 protected:
  Pass() {
    printer.run(0.2);
    printer.chip.from_firmware.clear();
  }

  void receive(std::string_view bytes) {
    printer.chip.to_firmware.insert(printer.chip.to_firmware.end(), bytes.begin(), bytes.end());
  }

  Printer printer;
};

TEST_F(Pass, takes_one_line_of_the_host) {
  receive("M118 a\nM118 b\nM118 c\n");
  for (const std::size_t left : {14u, 7u, 0u}) {
    printer.pass_without_sleep();
    EXPECT_EQ(printer.chip.to_firmware.size(), left);
  }
  printer.run(0.01);
  EXPECT_EQ(printer.chip.from_firmware, "a\nok\nb\nok\nc\nok\n");
}

TEST_F(Pass, takes_no_more_than_the_longest_line) {
  receive(std::string(300, 'x'));
  printer.pass_without_sleep();
  EXPECT_EQ(printer.chip.to_firmware.size(), 300 - application::task_timing::bytes_of_a_look);
}

TEST_F(Pass, says_one_line_of_a_list) {
  receive("M503\n");
  std::size_t longest = 0;
  std::size_t before = 0;
  for (int pass = 0; pass < 100; ++pass) {
    printer.pass_without_sleep();
    const auto lines =
        static_cast<std::size_t>(std::ranges::count(printer.chip.from_firmware, '\n'));
    longest = std::max(longest, lines - before);
    before = lines;
  }
  EXPECT_THAT(printer.chip.from_firmware, HasSubstr("ok\n"));
  EXPECT_GT(before, 8u);
  EXPECT_LE(longest, 2u);  // the last one with its ok
}

}  // namespace
}  // namespace application_test
