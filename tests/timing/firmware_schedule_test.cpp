// SPDX-License-Identifier: Apache-2.0
// The main loop of the firmware's image meets all deadlines at the clocks of the pages.
#include <gmock/gmock.h>

#include "directories.hpp"
#include "sim/processor/timing_table.hpp"
#include "tools/timing/schedule_report.hpp"

namespace timing {
namespace {

using testing::IsEmpty;

const Schedule& schedule() {
  static const Schedule once = [] {
    Program program = read_program(BUILD_DIRECTORY "/firmware/firmware.elf");
    program.memory_bytes = CHIP_MEMORY_BYTES;
    return schedule_of(program, Costs{processor::TimingTable()}, CHIP_HAS_ZBB,
                       application::schedule_facts(false, false));
  }();
  return once;
}

std::vector<std::string> misses(std::uint32_t clock_hz) {
  std::vector<std::string> names;
  for (const Response& response : respond(schedule().facts, schedule().load, {clock_hz, 250'000})) {
    if (!response.holds) names.emplace_back(row_of(response.requirement).name);
  }
  return names;
}

TEST(FirmwareSchedule, has_every_bound) {
  EXPECT_THAT(missing_bounds(schedule()), IsEmpty());
  EXPECT_TRUE(schedule().load.is_whole());
}

TEST(FirmwareSchedule, misses_no_deadline) {
  for (const std::uint32_t clock_hz : {4'000'000U, 8'000'000U, 25'000'000U, 50'000'000U}) {
    EXPECT_THAT(misses(clock_hz), IsEmpty()) << clock_hz;
  }
}

TEST(FirmwareSchedule, has_a_lowest_clock) {
  const ClockRange range = clocks_that_hold(schedule().facts, schedule().load, 250'000);
  EXPECT_FALSE(range.is_empty());
  EXPECT_GT(range.lowest_hz, 3'000'000U);
  EXPECT_THAT(misses(range.lowest_hz), IsEmpty());
  EXPECT_THAT(misses(range.lowest_hz - 1), testing::SizeIs(1));
}

}  // namespace
}  // namespace timing
