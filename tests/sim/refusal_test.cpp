// SPDX-License-Identifier: Apache-2.0
// Refused lines: which of them make a print bad, and with which reason they are listed.
#include "sim/report/refusal_log.hpp"

#include <gmock/gmock.h>

#include "sim/report/code_effects.hpp"

namespace {

using report::moves_or_heats;

TEST(CodeEffects, knows_the_codes_that_move_or_heat_or_say_where_to) {
  for (const char* line :
       {"G0 X1",     "g1x1",         "G2 X1 I5",  "G3 X1 R5",   "G5 X1",     "G10",
        "G11",       "G12",          "G20",       "G27",        "G28",       "G29",
        "G30",       "G38.2 Z-5",    "G60",       "G61",        "G91",       "G92 E0",
        "G999",      "M104 S200",    "M109 S200", "M140 S60",   "M141 S40",  "M190 S60",
        "M191 S40",  "M600",         "M601",      "M602",       "M603",      "M701",
        "M702",      "M125",         "M83",       "M92 E500",   "M221 S95",  "M206 X1",
        "T1",        "T?",           "X10 Y5",    "Y5",         "G17 G2 X5", "START_PRINT BED=60",
        "G1 X1.2.3", "M104 T1 S200", "M290 Z.1",  "M200 D1.75", "M23 a.gco", "M24",
        "M28 a.gco", "M29",          "M32 a.gco", "M808 L5",    "M37 S1",    "M111 S8",
        "M149 F",    "M149 K",       "G18",       "G19",        "M420 S1",   "M421 I1 J1 Z.1"}) {
    EXPECT_TRUE(moves_or_heats(line)) << line;
  }
}

TEST(CodeEffects, knows_the_codes_that_move_nothing) {
  for (const char* line : {"M862.3 P \"MK3S\"",
                           "M900 K30",
                           "M420 S0",
                           "M420 V",
                           "M486 S1",
                           "M73 P5",
                           "M117 G1 X5",
                           "M118 G28",
                           "M300 S440",
                           "M204 S0",
                           "M205 X99",
                           "M220 S0",
                           "M106 S300",
                           "M999",
                           "M503",
                           "G4 P1",
                           "G17",
                           "G21",
                           "G64",
                           "F3000",
                           "%",
                           "O1000",
                           "M1040",
                           "M10",
                           ""}) {
    EXPECT_FALSE(moves_or_heats(line)) << line;
  }
}

TEST(RefusalReason, leaves_out_what_only_repeats_the_line) {
  EXPECT_EQ(report::reason_of("echo:Unknown command: \"G2 X1\""), "Unknown command");
  EXPECT_EQ(
      report::reason_of("echo:Move beyond the end of X (0.00 to 200.00), not executed: \"G1\""),
      "Move beyond the end of X (0.00 to 200.00)");
  EXPECT_EQ(report::reason_of("echo: cold extrusion prevented"), "cold extrusion prevented");
  EXPECT_EQ(report::reason_of("echo:T1 Invalid extruder"), "T1 Invalid extruder");
  EXPECT_EQ(report::reason_of(""), "no reason given");
}

class RefusalLogTest : public testing::Test {
 protected:
  void send(std::size_t line, const std::string& command, const std::string& reply, bool executed) {
    log.command_sent(0, line, command);
    if (!reply.empty()) log.reply(0, reply);
    log.command_acknowledged(0, line, command, executed);
  }
  report::Findings findings() const {
    report::Findings result;
    log.report_to(result);
    return result;
  }
  report::RefusalLog log;
};

TEST_F(RefusalLogTest, lists_refused_lines_with_line_and_reason_and_keeps_warnings_apart) {
  send(3, "G2 X1 I1", "echo:Unknown command: \"G2 X1 I1\"", false);
  send(4, "M117 hello", "echo:hello", true);
  send(5, "M900 K1", "echo:Unknown command: \"M900 K1\"", false);
  send(6, "G1 X1 E9", "echo: cold extrusion prevented", true);
  const report::Findings found = findings();
  ASSERT_EQ(found.refused.size(), 2U);
  EXPECT_EQ(found.refused_count, 2U);
  EXPECT_EQ(found.refused[0].file_line, 3U);
  EXPECT_EQ(found.refused[0].text, "G2 X1 I1");
  EXPECT_EQ(found.refused[0].reason, "Unknown command");
  EXPECT_EQ(found.refused[1].file_line, 6U);
  EXPECT_EQ(found.refused[1].reason, "cold extrusion prevented");
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_EQ(found.warning_count, 1U);
  EXPECT_EQ(found.warnings[0].file_line, 5U);
}

TEST_F(RefusalLogTest, takes_no_reason_from_the_line_before) {
  send(1, "M117 hello", "echo:hello", true);
  send(2, "G2 X1", "", false);
  EXPECT_EQ(findings().refused.at(0).reason, "no reason given");
}

TEST_F(RefusalLogTest, counts_on_where_the_list_ends) {
  for (std::size_t line = 1; line <= 3000; ++line) {
    send(line, "G2 X1", "echo:Unknown command: \"G2 X1\"", false);
  }
  EXPECT_EQ(findings().refused_count, 3000U);
  EXPECT_EQ(findings().refused.size(), 1000U);
}

}  // namespace
