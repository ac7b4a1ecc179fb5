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
    host.emplace(*commands, line, rate);
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

  tests::FakeChip chip;
  sim::Simulation simulation{chip, rate};
  devices::SerialLine line{rate, 250'000, chip.inputs()};
  std::optional<devices::FileHost> host;
  std::vector<std::string> sent;
  std::vector<std::pair<std::size_t, bool>> acknowledged;

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

TEST_F(FileHostTest, sends_the_line_again_that_the_chip_asks_for) {
  print("G28\nG1 X1\n",
        {"ok\n", "Error:checksum mismatch, Last Line: 0\nResend: 1\nok\n", "ok\n", "ok\n"});
  EXPECT_THAT(sent,
              ElementsAre("N0 M110 N0*125", "N1 G28*18", "N1 G28*18", testing::_, testing::_));
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().resends, 1U);
  EXPECT_EQ(host->counts().commands_executed, 2U);
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
