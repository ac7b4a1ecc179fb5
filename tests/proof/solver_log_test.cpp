// SPDX-License-Identifier: Apache-2.0
// What the solver said, and what it did not say.
#include "tools/proof/solver_log.hpp"

#include <gmock/gmock.h>

namespace {

using testing::ElementsAre;

TEST(solver_log, reports_the_properties_that_failed_and_when) {
  const proof::SolverLog log = proof::read_solver_log(
      "##   0:00:00  Checking assertions in step 3..\n"
      "##   0:00:00  Checking assertions in step 4..\n"
      "##   0:00:01  BMC failed!\n"
      "##   0:00:01  Assert failed in axis_stepper: monitor.low_time_is_kept\n"
      "##   0:00:01  Assert failed in axis_stepper: a_b (f.v:3)\n"
      "##   0:00:01  Status: FAILED\n");
  EXPECT_EQ(log.holds, false);
  EXPECT_EQ(log.failed_at, 4);
  EXPECT_THAT(log.failed, ElementsAre("monitor.low_time_is_kept", "a_b"));
}

TEST(solver_log, holds_only_where_the_solver_says_so) {
  EXPECT_EQ(proof::read_solver_log("##   0:00:01  Status: PASSED\n").holds, true);
  EXPECT_EQ(proof::read_solver_log("").holds, std::nullopt);
  EXPECT_EQ(proof::read_solver_log("##   0:00:00  Checking assertions in step 0..\n").holds,
            std::nullopt);
}

TEST(solver_log, reports_the_solutions_by_the_values_in_their_last_clock) {
  const std::string text =
      "SAT solving finished - model found:\n\n"
      "  Time Signal Name   Dec   Hex   Bin\n"
      "  ---- ------------ ---- ---- ----\n"
      "  init \\a            1     1     1\n"
      "     1 \\a            0     0     00\n"
      "     1 \\b            0     0     0\n"
      "     2 \\a            2     2     10\n"
      "     2 \\b            0     0     0\n"
      "SAT solving finished - model found:\n\n"
      "     2 \\a            0     0     00\n"
      "     2 \\b            0     0     0\n"
      "SAT solving finished - no more models found\n";
  EXPECT_THAT(proof::read_solutions(text), ElementsAre("10 0 "));
}

}  // namespace
