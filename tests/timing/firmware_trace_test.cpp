// SPDX-License-Identifier: Apache-2.0
// The firmware's first instructions, from reset on.
#include <gtest/gtest.h>

#include "directories.hpp"
#include "sim/processor/timing_table.hpp"
#include "tests/timing/trace.hpp"

namespace timing {
namespace {

TEST(FirmwareTrace, costs_add_up_to_the_clocks) {
  Program program = read_program(BUILD_DIRECTORY "/firmware/firmware.elf");
  program.memory_bytes = CHIP_MEMORY_BYTES;
  const Costs costs{processor::TimingTable()};
  for (const std::uint32_t word : {0U, 1U, ~0U}) {
    const auto steps = trace(program, 0, 400'000, word);
    ASSERT_GT(steps.size(), 10'000U) << word;
    EXPECT_EQ(sum_of_costs(program, costs, steps), steps.back().begins - steps.front().begins)
        << word;
  }
}

}  // namespace
}  // namespace timing
