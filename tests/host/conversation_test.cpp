// SPDX-License-Identifier: Apache-2.0
// A feeder's conversation with the firmware's own host link: each line once and in order, whatever
// is lost, damaged, killed or restarted. In simulated time.
#include <gmock/gmock.h>

#include <random>

#include "tests/host/conversation_fixture.hpp"

namespace {

using namespace feeder;
using host_test::ConversationTest;
using namespace std::chrono_literals;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(ConversationTest, sends_each_line_once_and_knows_the_end_from_the_printer) {
  ASSERT_EQ(start(), "");
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished);
  EXPECT_TRUE(printer.said_at_rest) << "it was finished before its moves were";
  EXPECT_EQ(feed().done(), 50);
  EXPECT_EQ(feed().resends(), 0u);
  EXPECT_EQ(said.find("asked for again"), std::string::npos) << said;
  EXPECT_EQ(printer.executed, wanted);
  EXPECT_EQ(feed().temperatures().hotend, 21.5);
  EXPECT_EQ(feed().temperatures().bed, 20.25);
}

TEST_F(ConversationTest, starts_only_once_and_only_where_the_printer_answers) {
  EXPECT_NE(feed().start(7, "nowhere", 1), "") << "it has not answered yet";
  ASSERT_EQ(start(), "");
  run_until_executed(10);
  EXPECT_EQ(feed().start(7, "nowhere", 50), "") << "asked again, it is the same job";
  EXPECT_NE(feed().start(8, "nowhere", 50), "");
  run_to_end();
  EXPECT_NE(feed().start(8, "nowhere", 50), "") << "the outcome of 7 was not forgotten";
  EXPECT_EQ(feed().start(7, "nowhere", 50), "");
  run(20s);
  EXPECT_EQ(printer.executed, wanted);
  EXPECT_EQ(feed().forget(7), "");
  EXPECT_FALSE(feed().record());
}

TEST_F(ConversationTest, an_ok_that_is_lost_stops_nothing) {
  ASSERT_EQ(start(), "");
  for (std::size_t lines = 10; lines < 50; lines += 10) {
    run_until_executed(lines);
    printer.lose_next_ok();
  }
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished);
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, reports_of_the_printer_by_itself_do_not_stand_for_a_lost_ok) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  feed().update(now());
  ASSERT_NE(feed().take_output(), "") << "a line, of which the ok is lost";
  for (int i = 0; i < 5; ++i) {
    feed().heard("T:21.50 /0.00 B:20.25 /0.00 @:0 B@:0", now() + i * 2s);
    feed().update(now() + i * 2s);
  }
  EXPECT_EQ(feed().link(), Link::asking);
}

// The requirement: what waits with reports of its heat, as Marlin in M109, is not asked meanwhile.
TEST_F(ConversationTest, a_printer_that_reports_its_wait_for_heat_is_not_asked) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  feed().update(now());
  ASSERT_NE(feed().take_output(), "");
  for (int i = 0; i < 60; ++i) {
    feed().heard("T:30.00 /200.00 B:20.25 /0.00 @:127 B@:0 W:?", now() + i * 1s);
    feed().update(now() + i * 1s);
  }
  EXPECT_EQ(feed().link(), Link::ready);
}

TEST_F(ConversationTest, delivers_each_line_once_over_a_bad_cable) {
  ASSERT_EQ(start(2000), "");
  faults = 0.002;
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished) << why();
  EXPECT_GT(feed().resends(), 20u);
  EXPECT_EQ(printer.executed, wanted);
}

// The requirement: after a kill at any moment it goes on exactly where the printer is.
class KilledConversationTest : public ConversationTest {
 protected:
  void expect_all_once_with_kills_within(unsigned most_milliseconds) {
    ASSERT_EQ(start(3000), "");
    std::mt19937 random(3);
    int kills = 0;
    for (; kills < 200 && !is_over(phase()); ++kills) {
      run(Time(10 + random() % most_milliseconds));
      begin_feeder();
    }
    EXPECT_GE(kills, 10);
    run_to_end();
    EXPECT_EQ(phase(), Phase::finished) << why();
    EXPECT_EQ(printer.executed, wanted);
  }
};

TEST_F(KilledConversationTest, goes_on_at_the_line_that_the_printer_wants) {
  expect_all_once_with_kills_within(1500);
}

TEST_F(KilledConversationTest, goes_on_over_a_bad_cable_too) {
  faults = 0.002;
  expect_all_once_with_kills_within(2500);
}

TEST_F(ConversationTest, a_restarted_printer_interrupts_the_job_for_good) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  const auto before = executed_moves();
  printer.restart();
  run_to_end();
  EXPECT_EQ(phase(), Phase::interrupted);
  EXPECT_THAT(why(), HasSubstr("restarted"));
  begin_feeder();
  run(60s);
  EXPECT_EQ(phase(), Phase::interrupted);
  EXPECT_LE(executed_moves(), before + 1) << "the one on its way";
}

TEST_F(ConversationTest, a_printer_restarted_while_the_feeder_was_dead_interrupts_it_too) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  const auto before = executed_moves();
  printer.restart();
  printer.work(0ms);  // its greeting is lost
  begin_feeder();
  run_to_end();
  EXPECT_EQ(phase(), Phase::interrupted);
  run(60s);
  EXPECT_EQ(executed_moves(), before);
}

TEST_F(ConversationTest, one_damaged_answer_interrupts_nothing) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  begin_feeder();
  feed().update(1h);
  feed().heard("Resend: 12", 1h);
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished) << why();
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, an_m110_that_was_not_taken_is_sent_again_before_the_first_line) {
  ASSERT_EQ(start(), "");
  feed().update(0ms);
  EXPECT_THAT(feed().take_output(), HasSubstr("M110"));
  feed().heard("Resend: 1", 0ms);
  EXPECT_EQ(phase(), Phase::opening);
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished) << why();
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, killed_before_the_numbering_was_set_it_begins_at_the_first_line) {
  ASSERT_EQ(start(), "");
  EXPECT_EQ(phase(), Phase::opening);
  begin_feeder();
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished);
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, an_error_of_the_printer_ends_the_job) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  printer.halt("Error:Thermal Runaway, system stopped! Heater_ID: 0");
  run_to_end();
  EXPECT_EQ(phase(), Phase::failed);
  EXPECT_THAT(why(), HasSubstr("Thermal Runaway"));
  printer.restart();
  run(30s);
  EXPECT_EQ(feed().link(), Link::ready);
  EXPECT_LE(printer.executed.size(), 21u);
}

TEST_F(ConversationTest, a_file_that_has_lost_its_end_fails_the_job_with_the_heaters_off) {
  ASSERT_EQ(start(), "");
  run_until_executed(10);
  write_file("job", "G1 X1\n");
  begin_feeder();
  run_to_end();
  EXPECT_EQ(phase(), Phase::failed);
  run(5s);
  EXPECT_THAT(printer.executed, Contains("M104 S0"));
  EXPECT_THAT(printer.executed, Contains("M140 S0"));
  EXPECT_EQ(feed().link(), Link::ready);
}

TEST_F(ConversationTest, paused_it_sends_no_line_until_it_is_resumed_even_if_it_is_killed) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  EXPECT_EQ(feed().pause(), "");
  run(1s);
  const auto before = printer.executed.size();
  run(60s);
  begin_feeder();
  run(60s);
  EXPECT_EQ(phase(), Phase::paused);
  EXPECT_EQ(printer.executed.size(), before);
  EXPECT_EQ(feed().link(), Link::ready);
  EXPECT_EQ(feed().resume(), "");
  run_to_end();
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, cancelled_it_ends_with_everything_off_even_if_it_is_killed_meanwhile) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  EXPECT_EQ(feed().cancel(), "");
  begin_feeder();
  EXPECT_EQ(phase(), Phase::cancelling);
  run_to_end();
  EXPECT_EQ(phase(), Phase::cancelled);
  EXPECT_LE(printer.executed.size(), 25u);
  const std::vector<std::string> last(printer.executed.end() - 4, printer.executed.end());
  EXPECT_THAT(last, ElementsAre("M104 S0", "M140 S0", "M107", "M84"));
}

TEST_F(ConversationTest, stopped_at_once_it_sends_the_emergency_stop_and_nothing_more) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  feed().stop_everything();
  EXPECT_EQ(feed().take_output(), "M112\n");
  EXPECT_EQ(phase(), Phase::failed);
  EXPECT_THAT(why(), HasSubstr("emergency stop"));
}

TEST_F(ConversationTest, waits_for_the_user_and_resumes_the_printer) {
  write_job(3);
  run(1s);
  EXPECT_EQ(feed().send("M0 Change the filament"), "");
  run(5s);
  EXPECT_TRUE(feed().waits_for_user());
  EXPECT_TRUE(printer.waits());
  EXPECT_EQ(feed().resume(), "");
  run(5s);
  EXPECT_FALSE(printer.waits());
  EXPECT_FALSE(feed().waits_for_user());
}

TEST_F(ConversationTest, sends_a_persons_lines_between_those_of_the_job_but_no_line_numbers) {
  ASSERT_EQ(start(), "");
  run_until_executed(10);
  EXPECT_EQ(feed().send("M117 Hello "), "");
  EXPECT_NE(feed().send("M110 N5"), "");
  EXPECT_NE(feed().send("m110 N5"), "");
  EXPECT_NE(feed().send("N5 G28"), "");
  EXPECT_NE(feed().send("G28\nM110"), "");
  for (const char* numbered : {" M110 N5", "  N5 M105", "M110;N5", "M110*5", "M 110 N5", "m0110 N5",
                               " n5M105", "M110N5", "M\t110", "N-1 M110"}) {
    EXPECT_NE(feed().send(numbered), "") << numbered;
  }
  EXPECT_NE(feed().send(""), "");
  run_to_end();
  EXPECT_THAT(printer.typed, Contains("M117 Hello"));
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, a_typed_emergency_stop_is_sent_at_once_however_it_is_written) {
  run(1s);
  for (const char* stop : {"M112", " M112", "M112;x", "m112 ; now", "M 112", "M0112", "M112 S1"}) {
    EXPECT_EQ(feed().send(stop), "") << stop;
    EXPECT_EQ(feed().take_output(), "M112\n") << stop;
  }
}

TEST_F(ConversationTest, asks_a_silent_idle_printer_until_it_is_there) {
  printer.halt("");
  run(20s);
  EXPECT_EQ(feed().link(), Link::asking);
  printer.restart();
  run(5s);
  EXPECT_EQ(feed().link(), Link::ready);
}

}  // namespace
