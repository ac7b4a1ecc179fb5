// SPDX-License-Identifier: Apache-2.0
// A short search on the chip: no task, nor parser and planner, takes longer than its bound.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "sim/processor/timing_table.hpp"
#include "tests/loaded_printer.hpp"
#include "tools/command/worst_inputs_job.hpp"
#include "tools/files/file_text.hpp"
#include "tools/files/write_text.hpp"

namespace command {
namespace {

WorstInputs search(const WorstInputSearch& wanted) {
  timing::Program program = timing::read_program(tests::firmware_file);
  program.memory_bytes = CHIP_MEMORY_BYTES;
  return search_worst_inputs(program, timing::Costs{processor::TimingTable()}, wanted);
}

TEST(WorstInputs, take_no_longer_than_their_bounds) {
  constexpr std::uint64_t inputs = 768;
  WorstInputs found = search({.inputs = inputs});
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

TEST(WorstInputs, go_on_with_the_state_in_a_file) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "worst_inputs.state";
  std::filesystem::remove(file);
  const WorstInputs found = search({.inputs = 40, .state = file});
  const WorstInputs again = search({.inputs = 1, .state = file});
  EXPECT_EQ(again.inputs, 40U) << "they are there already";
  for (std::size_t task = 0; task < found.rows.size(); ++task) {
    EXPECT_EQ(again.rows[task].measured.longest, found.rows[task].measured.longest);
  }
  EXPECT_THROW(search({.inputs = 60, .seed = 2, .state = file}), std::runtime_error);
  files::write_text(file, "another file");
  EXPECT_THROW(search({.inputs = 60, .state = file}), std::runtime_error);
  EXPECT_EQ(files::text_of(file), "another file") << "what is no state is not written over";
}

}  // namespace
}  // namespace command
