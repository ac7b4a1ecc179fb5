// SPDX-License-Identifier: Apache-2.0
// Dialogues between the file host and a chip that says what each test lets it say.
#include "sim/devices/file_host.hpp"

#include <gmock/gmock.h>

#include <deque>

#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

using devices::HostState;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr sim::ClockRate rate(4'000'000);

class FileHostTest : public testing::Test, public devices::HostListener {
 protected:
  // Prints the text; the chip answers each line with the next of `answers`, then with ok.
  void print(const std::string& gcode, std::deque<std::string> answers = {}, double seconds = 60,
             bool says_start = true) {
    const auto commands = devices::parse_gcode_text(gcode, "test");
    ASSERT_TRUE(commands);
    options.note = [this](const std::string& note) { notes.push_back(note); };
    host.emplace(*commands, line, rate, options);
    host->add_listener(*this);
    simulation.attach(*host, {});
    chip.firmware = [this, answers](const std::string& text) mutable {
      sent.push_back(text);
      if (answers.empty()) {
        return std::string("ok\n");
      }
      const std::string answer = answers.front();
      answers.pop_front();
      return answer;
    };
    if (says_start) {
      chip.say("start\n");
    }
    simulation.run_until(rate.clocks(seconds));
  }

  void command_acknowledged(sim::Clock, std::size_t file_line, std::string_view,
                            bool executed) override {
    acknowledged.emplace_back(file_line, executed);
  }

  void reply(sim::Clock now, std::string_view) override { replies_at.push_back(now); }

  tests::FakeChip chip;
  sim::Simulation simulation{chip, rate};
  devices::SerialLine line{rate, 250'000, chip.inputs()};
  std::optional<devices::FileHost> host;
  devices::HostOptions options;
  std::vector<std::string> notes;
  std::vector<std::string> sent;
  std::vector<std::pair<std::size_t, bool>> acknowledged;
  std::vector<sim::Clock> replies_at;

  FileHostTest() { simulation.attach(line, sim::OutputPins::transmit_pin()); }
};

TEST_F(FileHostTest, numbers_lines_adds_checksums_and_ends_with_m400) {
  print("G28\nG1 X1.5 ; go\n");
  EXPECT_THAT(sent, ElementsAre("N0 M110 N0*125", "N1 G28*18", "N2 G1 X1.5*120", "N3 M400*36"));
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().lines_sent, 4U);
  EXPECT_EQ(host->counts().commands_executed, 2U);
  EXPECT_EQ(host->counts().resends, 0U);
}

TEST_F(FileHostTest, begins_without_start_after_a_second) {
  print("G28\n", {}, 0.9, false);
  EXPECT_TRUE(sent.empty());
  simulation.run_until(rate.clocks(2));
  EXPECT_EQ(host->state(), HostState::completed);
}

TEST_F(FileHostTest, waits_for_ok_before_the_next_line) {
  print("G28\nG1 X1\n", {"ok\n", "echo:busy: processing\n"}, 15);
  EXPECT_EQ(sent.size(), 2U);
  EXPECT_EQ(host->state(), HostState::printing);
  EXPECT_EQ(host->counts().busy_replies, 1U);
  chip.say("ok T:20.00 /0.00\n");
  simulation.run_until(rate.clocks(16));
  EXPECT_EQ(host->state(), HostState::completed);
}

// Nothing but the wire lies between an ok and the next: the line's bits, then those of the ok, each
// heard in the middle of its last stop bit.
TEST_F(FileHostTest, begins_the_next_line_in_the_clock_in_which_it_has_heard_the_ok) {
  print("G28\nG1 X1.5\nG1 X2.25 Y3\n");
  ASSERT_EQ(sent.size(), 5U);
  ASSERT_EQ(replies_at.size(), 6U);  // start, and an ok for each
  constexpr sim::Clock clocks_per_bit = 16;
  constexpr std::size_t ok_bits = 30;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const sim::Clock bits = 10 * (sent[i].size() + 1) + ok_bits - 1;
    EXPECT_NEAR(static_cast<double>(replies_at[i + 1] - replies_at[i]),
                static_cast<double>(bits * clocks_per_bit), 2)
        << sent[i];
  }
}

TEST_F(FileHostTest, sends_the_line_again_that_the_chip_asks_for) {
  print("G28\nG1 X1\n",
        {"ok\n", "Error:checksum mismatch, Last Line: 0\nResend: 1\nok\n", "ok\n", "ok\n"});
  EXPECT_THAT(sent,
              ElementsAre("N0 M110 N0*125", "N1 G28*18", "N1 G28*18", testing::_, testing::_));
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().resends, 1U);
  EXPECT_EQ(host->counts().commands_executed, 2U);
}

TEST_F(FileHostTest, begins_again_with_m110_whatever_number_is_asked_for_before_it_is_taken) {
  print("G28\n", {"echo:checksum mismatch, asked for again\nResend: 1\nok\n"});
  EXPECT_THAT(sent, ElementsAre("N0 M110 N0*125", "N0 M110 N0*125", "N1 G28*18", "N2 M400*37"));
  EXPECT_EQ(host->state(), HostState::completed);
}

TEST_F(FileHostTest, does_not_need_an_ok_after_resend) {
  print("G28\n", {"ok\n", "Resend: 1\n"});
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().resends, 1U);
}

TEST_F(FileHostTest, counts_no_command_twice_that_is_sent_again) {
  print("G28\nG1 X1\nG1 X2\n", {"ok\n", "ok\n", "ok\n", "Resend: 2\nok\n", "ok\n", "ok\n", "ok\n"});
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().commands_executed, 3U);
  EXPECT_EQ(acknowledged.size(), 5U);
}

TEST_F(FileHostTest, gives_up_on_a_line_that_is_refused_again_and_again) {
  std::deque<std::string> answers{"ok\n"};
  for (int i = 0; i < 20; ++i) {
    answers.push_back("Error:Line too long, Last Line: 0\nResend: 1\nok\n");
  }
  print("G28\n", answers);
  EXPECT_EQ(host->state(), HostState::faulted);
  EXPECT_THAT(host->fault(), HasSubstr("Line too long"));
  EXPECT_THAT(host->fault(), HasSubstr("line 1 \"G28\""));
}

TEST_F(FileHostTest, gives_up_where_the_chip_sends_it_back_to_an_old_line_for_ever) {
  // As after M110 N1 in the midst of a job: every answer but a repeat asks for line 1.
  const auto commands = devices::parse_gcode_text("G28\nG1 X1\nG1 X2\n", "test");
  host.emplace(*commands, line, rate);
  simulation.attach(*host, {});
  chip.firmware = [this](const std::string& text) {
    sent.push_back(text);
    return std::string(text.starts_with("N3") ? "Resend: 1\nok\n" : "ok\n");
  };
  chip.say("start\n");
  simulation.run_until(rate.clocks(60));
  EXPECT_EQ(host->state(), HostState::faulted);
  EXPECT_THAT(host->fault(), HasSubstr("asked 11 times for line number 1"));
  EXPECT_LT(sent.size(), 50U);
}

TEST_F(FileHostTest, does_not_send_m110_of_the_file_and_says_so) {
  print("G28\nM110 N55\nm110\nM1100\nG1 X1\n");
  EXPECT_THAT(sent, ElementsAre(HasSubstr("M110 N0"), HasSubstr("N1 G28"), HasSubstr("N2 M1100"),
                                HasSubstr("N3 G1 X1"), HasSubstr("N4 M400")));
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_THAT(notes[0], HasSubstr("line 2 \"M110 N55\" is not sent"));
  EXPECT_EQ(host->commands(), 3U);
}

TEST_F(FileHostTest, keeps_as_many_lines_in_flight_as_its_window_has) {
  options.window = 3;
  print("G1 X1\nG1 X2\nG1 X3\nG1 X4\nG1 X5\n", {"ok\n", "", "", "", "", "", ""}, 2);
  EXPECT_EQ(sent.size(), 4U);
  chip.say("ok\n");
  simulation.run_until(rate.clocks(3));
  EXPECT_EQ(sent.size(), 5U);
  chip.say("ok\nok\nok\nok\nok\n");
  simulation.run_until(rate.clocks(4));
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().commands_executed, 5U);
}

TEST_F(FileHostTest, sends_all_lines_again_from_the_one_that_is_asked_for) {
  options.window = 4;
  // Lines 2 and 3 are dropped by the chip, line 1 is answered later.
  print("G1 X1\nG1 X2\nG1 X3\nG1 X4\n",
        {"ok\n", "", "Error:checksum mismatch, Last Line: 1\nResend: 2\nok\nok\n", "", ""});
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().commands_executed, 4U);
  EXPECT_EQ(acknowledged.size(), 6U);
  EXPECT_THAT(sent, testing::Contains(HasSubstr("N2 G1 X2")).Times(2));
  EXPECT_THAT(sent, testing::Contains(HasSubstr("N1 G1 X1")).Times(1));
}

TEST_F(FileHostTest, puts_a_remark_to_the_first_of_several_lines_in_flight) {
  options.window = 3;
  print("G1 X1\nG2 X2\nG1 X3\n", {"ok\n", "", "", "ok\necho:Unknown command: \"G2 X2\"\nok\nok\n"});
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_THAT(acknowledged, ElementsAre(testing::_, std::pair(std::size_t{1}, true),
                                        std::pair(std::size_t{2}, false),
                                        std::pair(std::size_t{3}, true), testing::_));
}

constexpr const char* prompt =
    "//action:prompt_begin Waiting for the user\n//action:prompt_button Continue\n"
    "//action:prompt_show\n";

TEST_F(FileHostTest, answers_a_prompt_and_says_so) {
  print("G28\nM0\nG1 X1\n", {"ok\n", "ok\n", prompt, "//action:prompt_end\nok\nok\n"});
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_THAT(sent, testing::Contains("M108"));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "line 2 \"M0\" waits for the user: answered with M108");
  EXPECT_EQ(host->counts().commands_executed, 3U);
}

TEST_F(FileHostTest, answers_again_where_the_answer_is_lost) {
  print("M0\n", {"ok\n", prompt, "echo:busy: paused for user\n", "//action:prompt_end\nok\nok\n"});
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_THAT(sent, testing::Contains("M108").Times(2));
}

TEST_F(FileHostTest, does_not_answer_a_prompt_that_ends_by_itself) {
  for (const char* command : {"M0 S5", "m1 p500 Wait", "M0 S0.5"}) {
    sent.clear();
    print(std::string(command) + "\n", {"ok\n", prompt}, 10);
    EXPECT_THAT(sent, testing::Not(testing::Contains("M108"))) << command;
  }
}

TEST_F(FileHostTest, answers_a_prompt_whose_message_holds_a_number) {
  print("M0 Swap 2 parts\n", {"ok\n", prompt, "ok\nok\n"});
  EXPECT_THAT(sent, testing::Contains("M108"));
}

TEST_F(FileHostTest, ends_at_a_prompt_that_it_may_not_answer) {
  options.answers_prompts = false;
  print("G28\nM1 Swap\nG1 X1\n", {"ok\n", "ok\n", prompt});
  EXPECT_EQ(host->state(), HostState::faulted);
  EXPECT_EQ(host->fault(),
            "line 2 \"M1 Swap\" waits for the user, and --no-answer forbids to answer");
}

TEST_F(FileHostTest, ends_where_the_file_cancels_the_print_or_leaves_the_firmware) {
  print("M524\nG28\n", {"ok\n", "//action:cancel\nok\n"});
  EXPECT_EQ(host->fault(), "line 1 \"M524\" cancels the print");
}

TEST_F(FileHostTest, does_not_send_the_command_that_leaves_the_firmware) {
  print("G28\nM997\nG28\n");
  EXPECT_EQ(host->state(), HostState::faulted);
  EXPECT_THAT(host->fault(), HasSubstr("line 2 \"M997\" would leave the firmware"));
  EXPECT_THAT(sent, testing::Not(testing::Contains(HasSubstr("M997"))));
}

TEST_F(FileHostTest, goes_on_after_an_unknown_command_and_counts_it_as_refused) {
  print("G28\nM999\nG1 X1\n", {"ok\n", "ok\n", "echo:Unknown command: \"M999\"\nok\n"});
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().commands_executed, 2U);
  EXPECT_EQ(host->counts().commands_refused, 1U);
  EXPECT_EQ(acknowledged[2], std::pair(std::size_t{2}, false));
}

TEST_F(FileHostTest, takes_other_remarks_for_no_refusal) {
  print("G28\nG1 E5\n", {"ok\n", "ok\n", "echo: cold extrusion prevented\nok\n"});
  EXPECT_EQ(host->counts().commands_executed, 2U);
  EXPECT_EQ(host->counts().commands_refused, 0U);
}

TEST_F(FileHostTest, counts_what_the_chip_says_it_did_not_execute) {
  print("G28\nG1 X900\n",
        {"ok\n", "ok\n", "echo:Move beyond the end of X, not executed: \"G1 X900\"\nok\n"});
  EXPECT_EQ(host->counts().commands_refused, 1U);
}

TEST_F(FileHostTest, ends_at_a_fatal_error_and_names_the_line) {
  print("G28\nM109 S200\nG1 X1\n",
        {"ok\n", "ok\n", "Error:Thermal Runaway\nError:Printer halted. kill() called!\n"});
  EXPECT_EQ(host->state(), HostState::faulted);
  EXPECT_EQ(host->fault(), "Error:Thermal Runaway (at line 2 \"M109 S200\")");
  EXPECT_EQ(sent.size(), 3U);
}

TEST_F(FileHostTest, ends_where_the_chip_falls_silent_and_names_the_line) {
  print("G28\nG1 X1\n", {"ok\n", "ok\n", ""});
  EXPECT_EQ(host->state(), HostState::faulted);
  EXPECT_THAT(host->fault(), HasSubstr("did not answer within 20 s to line 2 \"G1 X1\""));
}

TEST_F(FileHostTest, ends_where_the_chip_restarts) {
  print("G28\nG1 X1\n", {"ok\n", "start\n"});
  EXPECT_EQ(host->state(), HostState::faulted);
  EXPECT_THAT(host->fault(), HasSubstr("restarted"));
}

TEST_F(FileHostTest, ends_where_the_chip_asks_for_a_line_that_was_never_sent) {
  print("G28\n", {"ok\n", "Resend: 7\nok\n"});
  EXPECT_EQ(host->state(), HostState::faulted);
  EXPECT_THAT(host->fault(), HasSubstr("never sent"));
}

}  // namespace
