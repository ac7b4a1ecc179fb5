// SPDX-License-Identifier: Apache-2.0
// How many of the firmware's functions have a bound: no fewer from one change to the next.
#include <gtest/gtest.h>

#include <algorithm>

#include "directories.hpp"
#include "sim/processor/timing_table.hpp"
#include "tools/timing/report.hpp"

namespace timing {
namespace {

// `main`, which does not end, and copies of a length that only their callers know: copy, move, fill
// and the three names by which the compiler calls them. Every other function shall have one.
constexpr std::ptrdiff_t most_without_bound = 7;

TEST(Coverage, few_functions_of_the_firmware_have_no_bound) {
  Program program = read_program(BUILD_DIRECTORY "/firmware/firmware.elf");
  program.memory_bytes = CHIP_MEMORY_BYTES;
  const auto rows = bounds(program, Costs{processor::TimingTable()}, CHIP_HAS_ZBB, {});
  const auto without = std::ranges::count_if(rows, [](const Row& row) { return !row.clocks; });
  EXPECT_GT(rows.size(), 300U);
  EXPECT_LE(without, most_without_bound) << "see ./stepfabric timing";
  for (const Row& row : rows) EXPECT_EQ(row.clocks.has_value(), row.problems.empty()) << row.name;
}

// By its lines: those into which the accesses are inlined, too.
TEST(Coverage, the_image_says_which_functions_access_the_bus) {
  const Program program = read_program(BUILD_DIRECTORY "/firmware/firmware.elf");
  ASSERT_TRUE(program.functions_on_bus);
  EXPECT_GT(program.functions_on_bus->size(), 10U);
  EXPECT_LT(program.functions_on_bus->size(), program.symbols.size() / 4);
  EXPECT_TRUE(program.may_access_bus(program.find("platform::bus_read").front()));
  EXPECT_FALSE(program.may_access_bus(program.find("gcode::parse").front()));
}

}  // namespace
}  // namespace timing
