// SPDX-License-Identifier: Apache-2.0
// How much one pass of the loop takes on.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "application/task_budgets.hpp"
#include "registers/temperature_converter_registers.hpp"
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
  for (const std::size_t left : {14u, 14u, 7u, 7u, 0u}) {
    printer.pass_without_sleep();
    EXPECT_EQ(printer.chip.to_firmware.size(), left) << "and in the next pass it executes one";
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

const application::TaskTimes& times_of(const Printer& printer, units::Task task) {
  return printer.counters.tasks[static_cast<std::size_t>(task)];
}

TEST_F(Pass, measures_each_task) {
  printer.talk("-> G92 X0\n<- ok\n-> G1 X5 F3000\n<- ok\n");
  printer.run(3);
  for (std::uint32_t task = 0; task < units::task_count; ++task) {
    EXPECT_GT(printer.counters.tasks[task].longest_clocks, 0u) << units::task_names[task];
    EXPECT_EQ(printer.counters.tasks[task].overruns, 0u) << units::task_names[task];
  }
  printer.talk("-> M122\n<- echo:Task overruns 1:0 2:0 3:0 4:0 5:0 6:0 7:0 8:0 9:0\n<- ok\n");
}

TEST_F(Pass, counts_the_task_that_takes_longer_than_its_budget) {
  // Only heat reads this.
  printer.chip.slow_address = registers::temperature_converter::Status::address_of(0);
  const std::uint32_t budget =
      application::task_budgets[static_cast<std::size_t>(units::Task::heat)];
  printer.chip.slow_clocks = budget;
  printer.run(1);
  EXPECT_GT(times_of(printer, units::Task::heat).longest_clocks, budget);
  const std::uint32_t overruns = times_of(printer, units::Task::heat).overruns;
  EXPECT_GT(overruns, 1u);
  for (std::uint32_t task = 0; task < units::task_count; ++task) {
    if (static_cast<units::Task>(task) == units::Task::heat) continue;
    EXPECT_EQ(printer.counters.tasks[task].overruns, 0u) << units::task_names[task];
  }
  printer.chip.slow_clocks = 0;
  printer.run(1);
  EXPECT_EQ(times_of(printer, units::Task::heat).overruns, overruns);
  EXPECT_GT(times_of(printer, units::Task::heat).longest_clocks, budget);
  printer.send("M122");
  EXPECT_THAT(printer.reply(),
              testing::Optional(HasSubstr(" 4:" + std::to_string(overruns) + " 5:0")));
}

}  // namespace
}  // namespace application_test
