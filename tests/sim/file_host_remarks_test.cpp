// SPDX-License-Identifier: Apache-2.0
// What the chip says besides: prompts, refusals, errors, silence.
#include "tests/sim/file_host_fixture.hpp"

namespace {

using devices::HostState;
using testing::HasSubstr;
using tests::FileHostTest;

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
