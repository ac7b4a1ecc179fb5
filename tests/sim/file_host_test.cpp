// SPDX-License-Identifier: Apache-2.0
// Lines out, ok and resends back, one or several in flight.
#include "tests/sim/file_host_fixture.hpp"

namespace {

using devices::HostState;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::FileHostTest;

TEST_F(FileHostTest, numbers_lines_adds_checksums_and_ends_with_m400) {
  print("G28\nG1 X1.5 ; go\n");
  EXPECT_THAT(sent, ElementsAre("N0 M110 N0*125", "N1 G28*18", "N2 G1 X1.5*120", "N3 M400*36"));
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->counts().lines_sent, 4U);
  EXPECT_EQ(host->counts().commands_executed, 2U);
  EXPECT_EQ(host->counts().resends, 0U);
}

// The numbers are the host's, and the file's would have it begin again.
TEST_F(FileHostTest, leaves_the_file_s_m110_out_however_it_is_written) {
  print("M110 N7\nM 110 N7\nm0110 N7\nM110N7\nM1100\nG28\n");
  EXPECT_THAT(sent, ElementsAre("N0 M110 N0*125", "N1 M1100*18", "N2 G28*17", "N3 M400*36"));
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
  // As after M110 N1 in the middle of a job: every answer but a repeat requests line 1.
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

// The last line went out twice, and of its second copy the chip knows only that it came damaged.
TEST_F(FileHostTest, ends_well_where_the_chip_asks_for_a_line_behind_the_last) {
  print("G28\n", {"ok\n", "ok\n", "Resend: 3\nok\nok\n"});
  EXPECT_EQ(host->state(), HostState::completed) << host->fault();
  EXPECT_THAT(sent, ElementsAre("N0 M110 N0*125", "N1 G28*18", "N2 M400*37"));
}

// Noise has made two damaged halves of line 1: it is requested twice, and both copies are answered.
TEST_F(FileHostTest, ends_only_when_the_last_line_is_answered_where_a_copy_was_answered_too) {
  print("G28\nG1 X1\n", {"ok\n", "Resend: 1\nok\nResend: 1\nok\n", "ok\n", "ok\n", "", "", "", ""},
        2);
  ASSERT_THAT(sent, testing::Contains("N3 M400*36"));
  chip.say("ok\n");  // to G1 X1
  simulation.run_until(rate.clocks(3));
  EXPECT_EQ(host->state(), HostState::printing);
  chip.say("ok\n");  // to M400
  simulation.run_until(rate.clocks(4));
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_EQ(host->commands(), 2U);
  EXPECT_EQ(host->counts().commands_executed, 2U);
}

// The same with two lines in flight: those of the first request are answered, and so are their
// copies; the chip works on M400.
TEST_F(FileHostTest, ends_only_when_the_last_line_is_answered_where_several_were_sent_twice) {
  options.window = 2;
  print("G28\nG1 X1\n",
        {"ok\n", "", "Resend: 2\nok\nok\nResend: 2\nok\n", "ok\n", "", "ok\n", "ok\n", "", "", ""},
        2);
  ASSERT_THAT(sent, testing::Contains("N3 M400*36").Times(2));
  EXPECT_EQ(host->state(), HostState::printing);
  chip.say("ok\n");
  simulation.run_until(rate.clocks(3));
  EXPECT_EQ(host->state(), HostState::completed);
}

// And then one of the copies comes damaged, so that the lines after it go out twice, too.
TEST_F(FileHostTest, ends_only_when_the_last_line_is_answered_where_a_copy_was_asked_for_again) {
  options.window = 2;
  print("G1 X1\nG1 X2\nG1 X3\n",
        {"ok\n", "Resend: 1\nok\nResend: 1\nok\n", "",  // lines 1 and 2
         "ok\n", "ok\n", "Resend: 3\nok\n", "ok\n",  // twice 1 and 2
         "ok\n", "", "ok\n", "ok\n",  // twice 3 and M400
         "", "", "", "", "", ""},
        2);
  ASSERT_THAT(sent, testing::Contains(HasSubstr("N1 G1 X1")).Times(3));
  ASSERT_THAT(sent, testing::Contains(HasSubstr("N4 M400")).Times(2));
  EXPECT_EQ(host->state(), HostState::printing);
  chip.say("ok\nok\n");
  simulation.run_until(rate.clocks(3));
  EXPECT_EQ(host->state(), HostState::completed);
}

TEST_F(FileHostTest, puts_a_remark_to_the_first_of_several_lines_in_flight) {
  options.window = 3;
  print("G1 X1\nG2 X2\nG1 X3\n", {"ok\n", "", "", "ok\necho:Unknown command: \"G2 X2\"\nok\nok\n"});
  EXPECT_EQ(host->state(), HostState::completed);
  EXPECT_THAT(acknowledged, ElementsAre(testing::_, std::pair(std::size_t{1}, true),
                                        std::pair(std::size_t{2}, false),
                                        std::pair(std::size_t{3}, true), testing::_));
}

}  // namespace
