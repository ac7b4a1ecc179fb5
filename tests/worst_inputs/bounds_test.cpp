// SPDX-License-Identifier: Apache-2.0
// A short search on the chip: no task, nor parser and planner, takes longer than its bound.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

#include "sim/processor/timing_table.hpp"
#include "tests/loaded_printer.hpp"
#include "tools/command/worst_inputs_job.hpp"

// What the handlers of the table need to be linked: none is called.
namespace platform {
std::uint32_t bus_read(std::uint32_t) { std::abort(); }
void bus_write(std::uint32_t, std::uint32_t) { std::abort(); }
bool enter_boot_loader() { std::abort(); }
}  // namespace platform

namespace command {
namespace {

TEST(WorstInputs, take_no_longer_than_their_bounds) {
  timing::Program program = timing::read_program(tests::firmware_file);
  program.memory_bytes = CHIP_MEMORY_BYTES;
  constexpr std::uint64_t inputs = 384;
  WorstInputs found =
      search_worst_inputs(program, timing::Costs{processor::TimingTable()}, inputs, 1);
  EXPECT_EQ(found.inputs, inputs);
  EXPECT_TRUE(holds(found)) << to_text(found);
  auto& pass = found.rows.back();
  EXPECT_GT(3 * pass.measured.longest, pass.bound.value()) << "the search found little";
  // It sees what is above a bound, and what has none.
  const auto bound = pass.bound;
  pass.bound = pass.measured.longest - found.between_tasks - 1;
  EXPECT_FALSE(holds(found));
  pass.bound.reset();
  EXPECT_FALSE(holds(found));
  pass.bound = bound;
  auto& parser = found.functions.front();
  parser.bound = parser.longest - 1;
  EXPECT_FALSE(holds(found));
}

}  // namespace
}  // namespace command
