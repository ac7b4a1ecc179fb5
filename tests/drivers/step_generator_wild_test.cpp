// SPDX-License-Identifier: Apache-2.0
// For any writes of a program and any inputs: the pins keep their guard times, no forbidden step
// occurs, each step is counted, and the latches are correct.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/drivers/wild_program.hpp"

namespace {

using tests::WildProgram;

class AWildProgram : public testing::TestWithParam<WildProgram::Clocks> {};

TEST_P(AWildProgram, moves_nothing_against_the_rules) {
  const char* asked = std::getenv("STEP_GENERATOR_RUNS");
  const int runs = asked != nullptr ? std::atoi(asked) : 60;
  std::uint64_t steps = 0, stops = 0, latches = 0;
  for (int seed = 1; seed <= runs; ++seed) {
    WildProgram program(static_cast<std::uint32_t>(seed), GetParam());
    try {
      program.run(1500);
    } catch (const tests::PinFault& fault) {
      FAIL() << "seed " << seed << ": " << fault.what();
    }
    steps += program.steps();
    stops += program.stops();
    latches += program.latches_compared();
  }
  // The run has reached the critical situations.
  const auto count = static_cast<std::uint64_t>(runs);
  EXPECT_GT(steps, 100 * count);
  EXPECT_GT(stops, 5 * count);
  EXPECT_GT(latches, count);
  RecordProperty("steps", std::to_string(steps));
}

INSTANTIATE_TEST_SUITE_P(with_all_edges_and_with_those_needed, AWildProgram,
                         testing::Values(WildProgram::Clocks::all, WildProgram::Clocks::needed));

}  // namespace
