// SPDX-License-Identifier: Apache-2.0
// A long pause: the hotend does not stay hot, and no line of the job is executed before it is as
// hot as it was.
#include <gmock/gmock.h>

#include "tests/host/conversation_fixture.hpp"

namespace {

using namespace feeder;
using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr Time limit = 10min;

class PauseTest : public host_test::ConversationTest {
 protected:
  PauseTest() {
    pause_limit = limit;
    begin_feeder();
  }
  void begin_hot(double celsius = 205) {
    ASSERT_EQ(start(), "");
    run_until_executed(1);
    ASSERT_EQ(feed().send("M104 S" + std::to_string(celsius)), "");
    run_until_executed(10);
    ASSERT_EQ(printer.hotend_target(), celsius);
  }
  void pause_for(Time time) {
    ASSERT_EQ(feed().pause(), "");
    run(time);
  }
  void kill_feeder() { begin_feeder(); }
  void expect_rest_is_printed_at(double celsius) {
    const std::size_t before = printer.executed.size();
    run_until_executed(before + 1);
    ASSERT_GT(printer.executed.size(), before) << "it does not go on";
    EXPECT_EQ(printer.hotend_target(), celsius);
    EXPECT_TRUE(celsius == 0 || *feed().temperatures().hotend > celsius - 20);
    EXPECT_FALSE(printer.heats()) << "a line was executed before the hotend was hot";
    run_to_end();
    EXPECT_EQ(phase(), Phase::finished);
    EXPECT_EQ(printer.executed, wanted);
    EXPECT_EQ(feed().hotend_to_restore(), 0);
  }
};

TEST_F(PauseTest, the_hotend_is_off_after_the_limit_and_hot_before_the_next_line) {
  begin_hot();
  pause_for(limit - 5s);
  EXPECT_EQ(printer.hotend_target(), 205);
  run(10s);
  EXPECT_EQ(printer.hotend_target(), 0);
  EXPECT_EQ(feed().hotend_to_restore(), 205);
  EXPECT_THAT(said, HasSubstr("hotend switched off after 10 min of pause"));
  EXPECT_THAT(printer.typed, Not(Contains("M140 S0"))) << "without its bed the part comes loose";
  const std::size_t executed = printer.executed.size();
  run(1h);
  EXPECT_EQ(printer.hotend_target(), 0);
  EXPECT_EQ(printer.executed.size(), executed);
  ASSERT_EQ(feed().resume(), "");
  expect_rest_is_printed_at(205);
}

TEST_F(PauseTest, short_pauses_leave_it_hot_and_are_not_added_up) {
  begin_hot();
  for (std::size_t i = 0; i < 3; ++i) {
    pause_for(limit - 1min);
    ASSERT_EQ(feed().resume(), "");
    run_until_executed(printer.executed.size() + 5);
    EXPECT_EQ(printer.hotend_target(), 205);
  }
  EXPECT_THAT(printer.typed, Not(Contains(HasSubstr("M109"))));
  expect_rest_is_printed_at(205);
}

TEST_F(PauseTest, without_a_limit_it_stays_hot) {
  pause_limit = 0s;
  begin_feeder();
  begin_hot();
  pause_for(2h);
  EXPECT_EQ(printer.hotend_target(), 205);
}

TEST_F(PauseTest, what_is_cold_is_left_cold) {
  ASSERT_EQ(start(), "");
  run_until_executed(10);
  pause_for(2 * limit);
  ASSERT_EQ(feed().resume(), "");
  expect_rest_is_printed_at(0);
}

// Each kill is one more chance to forget that the hotend must be heated.
TEST_F(PauseTest, a_feeder_that_is_killed_meanwhile_heats_it_all_the_same) {
  begin_hot();
  pause_for(limit + 5s);
  ASSERT_EQ(printer.hotend_target(), 0);
  kill_feeder();
  run(1min);
  ASSERT_EQ(feed().resume(), "");
  kill_feeder();
  for (int i = 0; i < 30 && !printer.heats(); ++i) run(100ms);
  ASSERT_TRUE(printer.heats());
  kill_feeder();
  run(5s);
  EXPECT_EQ(executed_moves(), std::ssize(printer.executed));
  expect_rest_is_printed_at(205);
}

TEST_F(PauseTest, a_kill_at_any_moment_after_resuming_prints_nothing_cold) {
  for (Time moment = 0ms; moment < 25s; moment += 700ms) {
    SCOPED_TRACE(moment.count());
    printer = {};
    wanted.clear();
    feed().forget(7);
    begin_feeder();
    begin_hot();
    pause_for(limit + 5s);
    ASSERT_EQ(feed().resume(), "");
    run(moment);
    if (printer.executed.size() > 20) {
      return;  // it was heated before
    }
    kill_feeder();
    expect_rest_is_printed_at(205);
    if (HasFatalFailure()) return;
  }
}

TEST_F(PauseTest, a_lost_ok_of_the_heating_is_no_reason_to_print_cold) {
  begin_hot();
  pause_for(limit + 5s);
  ASSERT_EQ(feed().resume(), "");
  for (int i = 0; i < 100 && !printer.heats(); ++i) run(10ms);
  ASSERT_TRUE(printer.heats());
  printer.lose_next_ok();
  expect_rest_is_printed_at(205);
}

TEST_F(PauseTest, a_noisy_cable_is_no_reason_to_print_cold_or_to_stay_hot) {
  for (int seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    printer = {};
    wanted.clear();
    feed().forget(7);
    begin_feeder();
    begin_hot();
    faults = 0.002;
    pause_for(limit + 1min);
    EXPECT_EQ(printer.hotend_target(), 0);
    ASSERT_EQ(feed().resume(), "");
    expect_rest_is_printed_at(205);
    faults = 0;
    if (HasFatalFailure()) return;
  }
}

TEST_F(PauseTest, what_a_person_sets_meanwhile_counts) {
  begin_hot();
  pause_for(limit + 5s);
  ASSERT_EQ(feed().send("M104 S190"), "");
  run(1min);
  EXPECT_EQ(printer.hotend_target(), 190) << "the person works on it";
  ASSERT_EQ(feed().resume(), "");
  expect_rest_is_printed_at(190);
}

TEST_F(PauseTest, a_person_who_heats_and_leaves_is_waited_for_as_long_again) {
  begin_hot();
  pause_for(limit + 5s);
  ASSERT_EQ(feed().send("M104 S190"), "");
  run(limit - 10s);
  EXPECT_EQ(printer.hotend_target(), 190);
  run(20s);
  EXPECT_EQ(printer.hotend_target(), 0);
  ASSERT_EQ(feed().resume(), "");
  expect_rest_is_printed_at(190);
}

TEST_F(PauseTest, says_nothing_of_a_hotend_that_it_cannot_switch_off) {
  begin_hot();
  ASSERT_EQ(feed().pause(), "");
  run(1s);
  ASSERT_EQ(feed().send("M0 Look"), "");
  run(2 * limit);
  ASSERT_TRUE(printer.waits());
  EXPECT_EQ(printer.hotend_target(), 205);
  EXPECT_THAT(said, Not(HasSubstr("switched off")));
  EXPECT_EQ(feed().hotend_to_restore(), 0);
  ASSERT_EQ(feed().resume(), "");
  expect_rest_is_printed_at(205);
}

TEST_F(PauseTest, ending_the_wait_for_heat_lets_nothing_be_printed_cold) {
  begin_hot();
  pause_for(limit + 5s);
  ASSERT_EQ(feed().resume(), "");
  run(3s);
  ASSERT_TRUE(printer.heats());
  ASSERT_EQ(feed().send("M108"), "");
  expect_rest_is_printed_at(205);
}

TEST_F(PauseTest, nothing_is_heated_while_everything_is_switched_off) {
  begin_hot();
  ASSERT_EQ(feed().cancel(), "");
  run(100ms);
  for (const char* line : {"M104 S200", "M109 S200", "M140 S60", "M190 S60"}) {
    EXPECT_NE(feed().send(line), "") << line;
  }
  run(15s);
  EXPECT_EQ(phase(), Phase::cancelled);
  EXPECT_EQ(printer.hotend_target(), 0);
}

TEST_F(PauseTest, cancelling_ends_the_heating) {
  begin_hot();
  pause_for(limit + 5s);
  ASSERT_EQ(feed().resume(), "");
  run(3s);
  ASSERT_TRUE(printer.heats());
  ASSERT_EQ(feed().cancel(), "");
  run(15s);
  EXPECT_EQ(phase(), Phase::cancelled);
  EXPECT_FALSE(printer.heats());
  EXPECT_EQ(printer.hotend_target(), 0);
}

TEST_F(PauseTest, a_pause_while_it_heats_has_the_whole_limit_again) {
  begin_hot();
  pause_for(limit + 5s);
  ASSERT_EQ(feed().resume(), "");
  run(3s);
  const std::size_t executed = printer.executed.size();
  pause_for(1min);
  EXPECT_EQ(printer.executed.size(), executed);
  EXPECT_EQ(printer.hotend_target(), 205);
  run(limit);
  EXPECT_EQ(printer.hotend_target(), 0);
  ASSERT_EQ(feed().resume(), "");
  expect_rest_is_printed_at(205);
}

TEST_F(PauseTest, a_full_disk_keeps_nothing_hot) {
  begin_hot();
  ASSERT_EQ(feed().pause(), "");
  set_disk_full(true);
  run(limit + 5s);
  EXPECT_EQ(printer.hotend_target(), 0);
  set_disk_full(false);
  run(2s);
  kill_feeder();
  run(5s);
  ASSERT_EQ(feed().resume(), "");
  expect_rest_is_printed_at(205);
}

}  // namespace
