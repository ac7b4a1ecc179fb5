// SPDX-License-Identifier: Apache-2.0
// A feeder's conversation with the firmware's own host link: each line once and in order, whatever
// is lost, damaged, killed or restarted. In simulated time.
#include "host/feeder/conversation.hpp"

#include <gmock/gmock.h>

#include <memory>
#include <random>

#include "tests/host/link_printer.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"

namespace {

using namespace feeder;
using namespace std::chrono_literals;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class ConversationTest : public testing::Test {
 protected:
  ConversationTest() { begin_feeder(); }

  // As after a kill: only the journal is left.
  void begin_feeder() {
    conversation_.reset();
    journal_.emplace(folder_.path() / "journal.json");
    conversation_ = std::make_unique<Conversation>(*journal_, [this] { return bases_ += 100'000; });
    conversation_->on_said = [this](std::string_view line) { said += std::string(line) + "\n"; };
    conversation_->opened(now_);
  }
  void write_job(int lines) {
    std::string text;
    for (int i = 1; i <= lines; ++i) {
      wanted.push_back("G1 X" + std::to_string(i));
      text += wanted.back() + "\n";
    }
    folder_.write("job", text);
  }
  std::string start(int lines = 50) {
    write_job(lines);
    run(1s);
    return feed().start(7, (folder_.path() / "job").string(), lines);
  }
  void run(Time time) {
    for (const Time end = now_ + time; now_ < end; now_ += 10ms) {
      feed().update(now_);
      printer.receive(disturbed(feed().take_output()), now_);
      std::string replies = disturbed(printer.work(now_));
      for (const char c : replies) {
        if (c == '\n') {
          feed().heard(std::exchange(line_, {}), now_);
        } else {
          line_ += c;
        }
      }
    }
  }
  // Until the job is over, or an hour has gone.
  void run_to_end() {
    for (int i = 0; i < 36'000 && !is_over(phase()); ++i) run(100ms);
  }
  void run_until_executed(std::size_t lines) {
    for (int i = 0; i < 36'000 && printer.executed.size() < lines; ++i) run(10ms);
  }
  Conversation& feed() { return *conversation_; }
  Phase phase() const { return conversation_->record()->phase; }
  std::string why() const { return conversation_->record()->why; }

  host_test::LinkPrinter printer;
  std::vector<std::string> wanted;
  std::string said;
  double faults = 0;  // of a byte

 private:
  std::string disturbed(std::string bytes) {
    std::bernoulli_distribution hit(faults);
    std::string out;
    for (char& c : bytes) {
      if (!hit(random_)) {
        out += c;
      } else if (random_() % 4 != 0) {  // otherwise it is lost
        out += static_cast<char>(c ^ (1 << random_() % 7));
      }
    }
    return out;
  }

  TemporaryFolder folder_;
  std::optional<Journal> journal_;
  std::unique_ptr<Conversation> conversation_;
  std::int64_t bases_ = Conversation::lowest_base;
  Time now_{0};
  std::string line_;
  std::mt19937 random_{7};
};

TEST_F(ConversationTest, sends_each_line_once_and_knows_the_end_from_the_printer) {
  ASSERT_EQ(start(), "");
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished);
  EXPECT_TRUE(printer.said_at_rest) << "it was finished before its moves were";
  EXPECT_EQ(feed().done(), 50);
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

TEST_F(ConversationTest, delivers_each_line_once_over_a_bad_cable) {
  ASSERT_EQ(start(2000), "");
  faults = 0.002;
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished) << why();
  EXPECT_GT(feed().resends(), 20u);
  EXPECT_EQ(printer.executed, wanted);
}

// The requirement: after a kill at any moment it goes on exactly where the printer is.
TEST_F(ConversationTest, killed_at_any_moment_it_goes_on_at_the_line_that_the_printer_wants) {
  ASSERT_EQ(start(3000), "");
  std::mt19937 random(3);
  int kills = 0;
  for (; kills < 200 && !is_over(phase()); ++kills) {
    run(Time(10 + random() % 1500));
    begin_feeder();
  }
  EXPECT_GE(kills, 10);
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished) << why();
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, killed_over_a_bad_cable_too) {
  ASSERT_EQ(start(3000), "");
  faults = 0.002;
  std::mt19937 random(5);
  int kills = 0;
  for (; kills < 200 && !is_over(phase()); ++kills) {
    run(Time(10 + random() % 2500));
    begin_feeder();
  }
  EXPECT_GE(kills, 10);
  run_to_end();
  EXPECT_EQ(phase(), Phase::finished) << why();
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, a_restarted_printer_interrupts_the_job_for_good) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  const auto before = printer.executed.size();
  printer.restart();
  run_to_end();
  EXPECT_EQ(phase(), Phase::interrupted);
  EXPECT_THAT(why(), HasSubstr("restarted"));
  begin_feeder();
  run(60s);
  EXPECT_EQ(phase(), Phase::interrupted);
  EXPECT_LE(printer.executed.size(), before + 1) << "the one on its way";
}

TEST_F(ConversationTest, a_printer_restarted_while_the_feeder_was_dead_interrupts_it_too) {
  ASSERT_EQ(start(), "");
  run_until_executed(20);
  const auto before = printer.executed.size();
  printer.restart();
  printer.work(0ms);  // its greeting is lost
  begin_feeder();
  run_to_end();
  EXPECT_EQ(phase(), Phase::interrupted);
  run(60s);
  EXPECT_EQ(printer.executed.size(), before);
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
  EXPECT_NE(feed().send(""), "");
  run_to_end();
  EXPECT_THAT(printer.typed, Contains("M117 Hello"));
  EXPECT_EQ(printer.executed, wanted);
}

TEST_F(ConversationTest, asks_a_silent_idle_printer_until_it_is_there) {
  printer.halt("");
  run(20s);
  EXPECT_EQ(feed().link(), Link::asking);
  printer.restart();
  run(5s);
  EXPECT_EQ(feed().link(), Link::ready);
}

TEST(framing, adds_number_and_checksum_as_hosts_do) {
  EXPECT_EQ(framed(0, "M110 N0"), "N0 M110 N0*125\n");
  EXPECT_EQ(framed(3, "T0"), "N3 T0*57\n");
}

TEST(framing, reads_what_printers_say) {
  EXPECT_EQ(resend_in("Resend: 17"), 17);
  EXPECT_EQ(resend_in("Resend:17"), 17);
  EXPECT_EQ(resend_in("rs N17"), 17);
  EXPECT_FALSE(resend_in("Resend: x"));
  EXPECT_FALSE(resend_in("ok 17"));
  Temperatures heat;
  EXPECT_TRUE(read_temperatures("ok T:201.25 /205.00 B:60.5 /60.00 @:12 B@:3", heat));
  EXPECT_EQ(heat.hotend, 201.25);
  EXPECT_EQ(heat.hotend_target, 205);
  EXPECT_EQ(heat.bed, 60.5);
  EXPECT_EQ(heat.bed_target, 60);
  EXPECT_FALSE(read_temperatures("echo:busy: processing", heat));
  EXPECT_FALSE(read_temperatures("FIRMWARE_NAME:Marlin EXTRUDER_COUNT:1", heat));
  EXPECT_TRUE(is_fatal("Error:Thermal Runaway"));
  EXPECT_TRUE(is_fatal("!! halted"));
  EXPECT_FALSE(is_fatal("Error:checksum mismatch, Last Line: 5"));
  EXPECT_FALSE(is_fatal("echo:Unknown command"));
}

TEST(command_file, is_read_forwards_and_backwards) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 1; i <= 500; ++i) text += "line " + std::to_string(i) + "\n";
  folder.write("commands", text);
  CommandFile file(folder.path() / "commands");
  for (const int i : {1, 2, 300, 299, 298, 500, 1, 450, 440, 386, 500}) {
    EXPECT_EQ(file.at(i), "line " + std::to_string(i));
  }
  EXPECT_THROW(file.at(501), std::runtime_error);
  EXPECT_EQ(file.at(500), "line 500");
}

TEST(journal, is_the_same_after_it_was_read_again_and_refuses_what_is_none) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "journal.json";
  Journal(path).write({.job = 5,
                       .file = "/a/b",
                       .commands = 9,
                       .base = 1 << 20,
                       .phase = Phase::paused,
                       .why = "because"});
  Journal again(path);
  ASSERT_TRUE(again.record());
  EXPECT_EQ(again.record()->job, 5);
  EXPECT_EQ(again.record()->file, "/a/b");
  EXPECT_EQ(again.record()->commands, 9);
  EXPECT_EQ(again.record()->base, 1 << 20);
  EXPECT_EQ(again.record()->phase, Phase::paused);
  EXPECT_EQ(again.record()->why, "because");
  again.clear();
  EXPECT_FALSE(Journal(path).record());
  folder.write("journal.json", "{\"job\": 5");
  EXPECT_THROW(Journal{path}, std::runtime_error);
}

}  // namespace
