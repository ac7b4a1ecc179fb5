// SPDX-License-Identifier: Apache-2.0
// What people type into the console, and which reports they see there.
#include <gmock/gmock.h>

#include "tests/host/conversation_fixture.hpp"

namespace host_test {
namespace {

using namespace std::chrono_literals;

TEST_F(ConversationTest, refuses_what_a_person_types_where_it_would_disturb_a_running_print) {
  const std::vector<std::string> disturbing{
      "G1 X5", "g28",  "G92 X0", "G55",       "M206 X1", "G91", "M83",  "M18",
      "M84",   "M400", "M0",     "M109 S200", "M92 X1",  "T1",  "M410", "M302 P1"};
  ASSERT_EQ(start(), "");
  run_until_executed(10);
  for (const std::string& line : disturbing) {
    EXPECT_THAT(feed().send(line), testing::HasSubstr("pause it first")) << line;
  }
  for (const char* line :
       {"M105", "M114", " m220 S90", "M290 Z0.05", "M104 S210", "M106 S255", "M117 text"}) {
    EXPECT_EQ(feed().send(line), "") << line;
  }
  EXPECT_EQ(feed().pause(), "");
  EXPECT_EQ(feed().send("G1 X5"), "");  // a person's decision
  EXPECT_EQ(feed().resume(), "");
  run_to_end();
  EXPECT_EQ(printer.executed, wanted);
  EXPECT_EQ(feed().send("G28"), "");  // it is over
}

// What comes by itself would hide all else.
TEST_F(ConversationTest, shows_reports_only_where_a_person_has_asked) {
  std::vector<std::string> lines;
  run(5s);
  feed().on_said = [&lines](std::string_view line) { lines.emplace_back(line); };
  printer.say("X:1.00 Y:2.00 Z:3.00 E:0.00 Count X:80 Y:160 Z:7680");
  run(3s);
  ASSERT_TRUE(feed().position());
  EXPECT_EQ(feed().position()->steps[2], 7680);
  EXPECT_THAT(lines, testing::IsEmpty());
  EXPECT_EQ(feed().send("M105"), "");
  run(6s);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_THAT(lines[1], testing::HasSubstr("T:21.50"));
  feed().closed();
  EXPECT_FALSE(feed().position());  // what happens to it now is not known
}

}  // namespace
}  // namespace host_test
