// SPDX-License-Identifier: Apache-2.0
// Which deadlines the main loop of the firmware's image misses at which clock.
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
                       application::schedule_facts(false));
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

// Bounds that are still above what must be in hand for their task.
TEST(FirmwareSchedule, misses_nothing_else) {
  const auto tasks = {"each task keeps to its allowance", "the queue holds what each task needs"};
  EXPECT_THAT(misses(25'000'000), testing::ElementsAreArray(tasks));
  EXPECT_THAT(misses(50'000'000), testing::ElementsAreArray(tasks));
}

}  // namespace
}  // namespace timing
