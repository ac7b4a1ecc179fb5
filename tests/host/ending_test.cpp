// SPDX-License-Identifier: Apache-2.0
// However a job ends, its heaters are switched off where the printer still answers, once, and a
// person's stop is obeyed whatever the disk does. In simulated time.
#include <gmock/gmock.h>

#include "tests/host/conversation_fixture.hpp"

namespace {

using namespace feeder;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

class EndingTest : public host_test::ConversationTest {
 protected:
  void print_some() {
    ASSERT_EQ(start(), "");
    run_until_executed(20);
  }
  void expect_all_off_once() {
    ASSERT_GE(printer.executed.size(), 4u);
    const std::vector<std::string> last(printer.executed.end() - 4, printer.executed.end());
    EXPECT_THAT(last, ElementsAre("M104 S0", "M140 S0", "M107", "M84"));
    EXPECT_EQ(executed("M104 S0"), 1);
  }
};

TEST_F(EndingTest, a_second_cancel_changes_nothing) {
  print_some();
  EXPECT_EQ(feed().cancel(), "");
  EXPECT_EQ(feed().cancel(), "");
  run(20ms);
  EXPECT_EQ(feed().cancel(), "");
  EXPECT_EQ(phase(), Phase::cancelling);
  run_to_end();
  EXPECT_EQ(phase(), Phase::cancelled);
  EXPECT_EQ(why(), "");
  expect_all_off_once();
}

TEST_F(EndingTest, a_dead_printer_is_given_up_with_a_warning_after_several_questions) {
  print_some();
  printer.halt("");
  EXPECT_EQ(feed().cancel(), "");
  EXPECT_EQ(feed().cancel(), "");
  run(10s);
  EXPECT_EQ(feed().cancel(), "");
  EXPECT_EQ(phase(), Phase::cancelling);
  run(60s);
  EXPECT_EQ(phase(), Phase::cancelled);
  EXPECT_THAT(why(), HasSubstr("heaters"));
}

TEST_F(EndingTest, a_printer_that_dies_during_the_closing_lines_is_given_up_too) {
  print_some();
  EXPECT_EQ(feed().cancel(), "");
  while (executed("M104 S0") == 0) run(10ms);
  printer.halt("");
  run(60s);
  EXPECT_EQ(phase(), Phase::cancelled);
  EXPECT_THAT(why(), HasSubstr("heaters"));
}

TEST_F(EndingTest, without_a_port_a_second_cancel_gives_up_with_a_warning) {
  print_some();
  feed().closed();
  EXPECT_EQ(feed().cancel(), "");
  EXPECT_EQ(phase(), Phase::cancelling) << "the port may come again";
  EXPECT_EQ(feed().cancel(), "");
  EXPECT_EQ(phase(), Phase::cancelled);
  EXPECT_THAT(why(), HasSubstr("heaters"));
}

TEST_F(EndingTest, an_error_of_a_printer_that_still_answers_switches_everything_off) {
  print_some();
  printer.say("Error:something odd");
  run_to_end();
  EXPECT_EQ(phase(), Phase::failed);
  EXPECT_THAT(why(), HasSubstr("something odd"));
  EXPECT_LE(executed_moves(), 22);
  expect_all_off_once();
}

TEST_F(EndingTest, a_kill_of_the_feeder_loses_neither_closing_lines_nor_reason) {
  print_some();
  printer.say("Error:something odd");
  run(20ms);
  EXPECT_EQ(phase(), Phase::cancelling);
  begin_feeder();
  run_to_end();
  EXPECT_EQ(phase(), Phase::failed);
  EXPECT_THAT(why(), HasSubstr("something odd"));
  expect_all_off_once();
}

TEST_F(EndingTest, the_closing_lines_are_sent_again_until_they_are_taken) {
  print_some();
  faults = 0.01;
  printer.say("Error:something odd");
  run_to_end();
  EXPECT_EQ(phase(), Phase::failed);
  expect_all_off_once();
}

TEST_F(EndingTest, an_interrupted_job_switches_everything_off) {
  print_some();
  printer.restart();
  run_to_end();
  EXPECT_EQ(phase(), Phase::interrupted);
  expect_all_off_once();
}

TEST_F(EndingTest, a_job_whose_file_is_gone_switches_everything_off) {
  print_some();
  std::filesystem::remove(folder() / "job");
  begin_feeder();
  run_to_end();
  EXPECT_EQ(phase(), Phase::interrupted);
  EXPECT_THAT(why(), HasSubstr("cannot read"));
  expect_all_off_once();
}

TEST_F(EndingTest, a_printer_that_restarts_during_the_closing_lines_gets_them_again) {
  print_some();
  EXPECT_EQ(feed().cancel(), "");
  while (executed("M104 S0") == 0) run(10ms);
  printer.executed.clear();
  printer.restart();
  run_to_end();
  EXPECT_EQ(phase(), Phase::cancelled);
  expect_all_off_once();
}

TEST_F(EndingTest, a_job_that_is_over_or_forgotten_can_be_cancelled_to_switch_the_heaters_off) {
  print_some();
  printer.say("Error:something odd");
  run_to_end();
  printer.executed.clear();
  EXPECT_EQ(feed().cancel(7), "");
  EXPECT_EQ(phase(), Phase::cancelling);
  run_to_end();
  EXPECT_EQ(phase(), Phase::failed) << "its outcome stays";
  expect_all_off_once();
  EXPECT_EQ(feed().forget(7), "");
  printer.executed.clear();
  EXPECT_EQ(feed().cancel(7), "");
  run_to_end();
  EXPECT_EQ(phase(), Phase::cancelled);
  EXPECT_EQ(feed().record()->job, 7);
  expect_all_off_once();
}

TEST_F(EndingTest, a_cancel_of_another_job_leaves_the_print_alone) {
  print_some();
  EXPECT_THAT(feed().cancel(8), HasSubstr("job 7"));
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished);
}

TEST_F(EndingTest, with_nothing_to_print_a_cancel_switches_heaters_off_that_are_on) {
  run(3s);
  EXPECT_NE(feed().cancel(), "") << "they are off";
  feed().heard("T:180.00 /200.00 B:20.00 /0.00", now());
  EXPECT_EQ(feed().cancel(), "");
  run_to_end();
  expect_all_off_once();
}

TEST_F(EndingTest, a_cancel_is_obeyed_and_the_heaters_are_off_although_the_disk_is_full) {
  print_some();
  set_disk_full(true);
  EXPECT_EQ(feed().cancel(), "");
  run_to_end();
  EXPECT_EQ(phase(), Phase::cancelled);
  expect_all_off_once();
  EXPECT_THAT(feed().fault(), HasSubstr("cannot write"));
  set_disk_full(false);
  run(5s);
  EXPECT_EQ(feed().fault(), "");
  begin_feeder();
  EXPECT_EQ(phase(), Phase::cancelled) << "it was not written later";
}

TEST_F(EndingTest, a_pause_is_obeyed_although_the_disk_is_full) {
  print_some();
  set_disk_full(true);
  EXPECT_EQ(feed().pause(), "");
  run(1s);
  const auto before = printer.executed.size();
  run(20s);
  EXPECT_EQ(printer.executed.size(), before);
  EXPECT_NE(feed().fault(), "");
}

TEST_F(EndingTest, an_emergency_stop_is_obeyed_although_the_disk_is_full) {
  print_some();
  set_disk_full(true);
  feed().stop_everything();
  EXPECT_EQ(phase(), Phase::failed);
  const auto before = printer.executed.size();
  run(20s);
  EXPECT_EQ(printer.executed.size(), before);
}

TEST_F(EndingTest, a_print_goes_on_and_its_end_is_known_although_the_disk_is_full) {
  print_some();
  set_disk_full(true);
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished);
  EXPECT_EQ(printer.executed, wanted);
}

// Otherwise a kill of the feeder would print its lines once more.
TEST_F(EndingTest, no_line_of_a_job_leaves_before_the_journal_has_its_numbering) {
  ASSERT_EQ(start(), "");
  set_disk_full(true);
  run_to_end();
  EXPECT_EQ(phase(), Phase::failed);
  EXPECT_EQ(executed_moves(), 0);
  expect_all_off_once();
}

TEST_F(EndingTest, a_damaged_journal_is_set_aside_and_everything_is_switched_off) {
  print_some();
  write_file("journal.json", "{\"job\": 7");
  begin_feeder();
  EXPECT_THAT(feed().fault(), HasSubstr("journal"));
  run_to_end();
  EXPECT_EQ(phase(), Phase::interrupted);
  EXPECT_EQ(feed().record()->job, 0) << "which one it was is not known";
  EXPECT_THAT(why(), HasSubstr("journal.json.damaged"));
  expect_all_off_once();
  EXPECT_TRUE(std::filesystem::exists(folder() / "journal.json.damaged"));
}

}  // namespace
